// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/random_surface.hpp"

#include "oracle/collapse.hpp"
#include "oracle/gluing.hpp"
#include "oracle/split.hpp"

namespace multimesh::oracle {

namespace {

/// The 7-vertex torus of Möbius and Császár, as a cyclic triangulation.
Complex torus7() {
  Complex torus{2, {}};
  for (int i = 0; i < 7; ++i) {
    torus.facets.push_back({i, (i + 1) % 7, (i + 3) % 7});
    torus.facets.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return torus;
}

Complex ring() {
  Complex annulus{2, {}};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    annulus.facets.push_back({i, j, i + 3});
    annulus.facets.push_back({j, j + 3, i + 3});
  }
  return annulus;
}

Complex moebius5() {
  Complex band{2, {}};
  for (int i = 0; i < 5; ++i) band.facets.push_back({i, (i + 1) % 5, (i + 2) % 5});
  return band;
}

}  // namespace

Complex base_surface(Surface kind) {
  Complex torus = torus7();
  switch (kind) {
    case Surface::kDisk:
      return {2, {{0, 1, 2}}};
    case Surface::kSphere:
      return {2, {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
    case Surface::kAnnulus:
      return ring();
    case Surface::kMoebius:
      return moebius5();
    case Surface::kHoledTorus:
      torus.facets.pop_back();
      return torus;
    default:
      return torus;
  }
}

std::size_t pick(std::mt19937_64& rng, std::size_t n) {
  return static_cast<std::size_t>(rng() % n);
}

bool chance(std::mt19937_64& rng, std::size_t percent) {
  return pick(rng, 100) < percent;
}

namespace {

Simplex random_edge(const Complex& mesh, std::mt19937_64& rng) {
  const auto& f = mesh.facets[pick(rng, mesh.facets.size())];
  const std::size_t i = pick(rng, 3);
  return simplex({f[i], f[(i + 1) % 3]});
}

void random_split(Complex& mesh, std::mt19937_64& rng) {
  const Simplex e = random_edge(mesh, rng);
  mesh = split({{{mesh, -1, {}}}}, e.v[0], e.v[1]).tree.nodes[0].mesh;
}

bool random_collapse(Complex& mesh, std::mt19937_64& rng) {
  const Simplex e = random_edge(mesh, rng);
  if (!link_condition(mesh, e.v[0], e.v[1])) return false;
  mesh = collapse({{{mesh, -1, {}}}}, e.v[0], e.v[1]).tree.nodes[0].mesh;
  return true;
}

/// Replaces abc, abd by cdb, dca where cd is not yet an edge.
void random_flip(Complex& mesh, std::mt19937_64& rng) {
  const Simplex e = random_edge(mesh, rng);
  const std::vector<EdgeUse> uses = edge_uses(mesh);
  for (const EdgeUse& use : uses) {
    if (use.edge != e || use.count != 2) continue;
    auto& f = mesh.facets[static_cast<std::size_t>(use.facet[0])];
    auto& g = mesh.facets[static_cast<std::size_t>(use.facet[1])];
    const auto i = static_cast<std::size_t>(use.corner[0]);
    const int c = f[i], a = f[(i + 1) % 3], b = f[(i + 2) % 3];
    const int d = g[static_cast<std::size_t>(use.corner[1])];
    if (contains(simplices(mesh, 1), simplex({c, d}))) return;
    f = {c, a, d};
    g = {d, b, c};
    return;
  }
}

}  // namespace

Complex random_surface(Surface kind, std::size_t facets, std::mt19937_64& rng) {
  Complex mesh = base_surface(kind);
  const std::size_t most = facets + pick(rng, 8);
  while (mesh.facets.size() < most) {
    random_split(mesh, rng);
    if (chance(rng, 40)) random_flip(mesh, rng);
  }
  for (std::size_t i = pick(rng, 2 * facets); i > 0; --i) random_flip(mesh, rng);
  for (int attempt = 0; attempt < 200 && mesh.facets.size() > facets; ++attempt) random_collapse(mesh, rng);
  return mesh;
}

}  // namespace multimesh::oracle
