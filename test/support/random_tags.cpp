// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/random_tags.hpp"

namespace multimesh::test {

std::vector<bool> random_path(const Mesh& mesh, std::size_t length, std::mt19937& random) {
  std::vector<bool> tagged(mesh.capacity(1), false), visited(mesh.capacity(0), false);
  Dart at = mesh.dart_of(0, static_cast<Index>(random() % mesh.capacity(0)));
  visited[mesh.vertex(at)] = true;
  DartBuffer star;
  for (std::size_t i = 0; i < length; ++i) {
    mesh.star(at, 0, star);
    bool moved = false;
    for (int tries = 0; tries < 8 && !moved; ++tries) {
      const Dart edge = star[random() % star.size()], there = mesh.switch_dart(edge, 0);
      if (visited[mesh.vertex(there)]) continue;
      visited[mesh.vertex(there)] = true;
      tagged[mesh.simplex(edge, 1)] = moved = true;
      at = there;
    }
    if (!moved) break;
  }
  return tagged;
}

std::function<bool(Index)> random_points(const Mesh& mesh, unsigned seed, unsigned share) {
  std::mt19937 random(seed);
  std::vector<bool> tagged(mesh.capacity(0), false);
  Index in_facet = no_index;
  for (Index v = 0; v < tagged.size(); ++v) {
    if (!mesh.is_live(0, v) || mesh.dart_of(0, v) == no_dart) continue;
    tagged[v] = random() % share == 0;
    in_facet = v;
  }
  tagged.at(in_facet) = true;
  return [tagged](Index v) { return v < tagged.size() && tagged[v]; };
}

std::function<bool(Index)> random_seams(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  auto seam = random_path(mesh, 3 + mesh.capacity(1) / 12, random);
  const auto second = random_path(mesh, 2 + mesh.capacity(1) / 20, random);
  for (std::size_t e = 0; e < seam.size(); ++e) seam[e] = seam[e] || second[e];
  return [seam](Index e) { return e < seam.size() && seam[e]; };
}

std::vector<bool> random_lump(const Mesh& mesh, std::size_t size, std::mt19937& random) {
  const int d = mesh.dimension();
  std::vector<bool> in(mesh.capacity(d), false);
  DartBuffer lump;
  while (lump.empty()) {
    const auto f = static_cast<Index>(random() % mesh.capacity(d));
    if (mesh.is_live(d, f)) lump.push_back(mesh.dart_of(d, f));
  }
  in[mesh.facet(lump[0])] = true;
  const unsigned orders = d == 3 ? 24 : d == 2 ? 6 : 2;
  for (std::size_t tries = 0; tries < 20 * size && lump.size() < size; ++tries) {
    const Dart from = lump[random() % lump.size()];
    const Dart next = mesh.switch_dart(mesh.reorder(from, {static_cast<std::uint8_t>(random() % orders)}), d);
    if (next == no_dart || in[mesh.facet(next)]) continue;
    in[mesh.facet(next)] = true;
    lump.push_back(next);
  }
  return in;
}

std::vector<bool> random_frontier(const Mesh& mesh, std::size_t tets, bool with_boundary,
                                  std::mt19937& random) {
  const std::vector<bool> in = random_lump(mesh, tets, random);
  std::vector<bool> tagged(mesh.capacity(2), false);
  for (Index s = 0; s < mesh.capacity(2); ++s) {
    if (!mesh.is_live(2, s)) continue;
    const Dart here = mesh.dart_of(2, s), there = mesh.switch_dart(here, 3);
    tagged[s] = there == no_dart ? with_boundary && in[mesh.facet(here)]
                                 : in[mesh.facet(here)] != in[mesh.facet(there)];
  }
  return tagged;
}

}  // namespace multimesh::test
