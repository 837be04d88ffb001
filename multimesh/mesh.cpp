// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/mesh.hpp"

#include <algorithm>
#include <array>

#include "multimesh/error.hpp"
#include "multimesh/faces.hpp"

namespace multimesh {

void Mesh::set_locked(Index, bool) {
  throw UsageError("this mesh stores no locks of vertices");
}

void Mesh::keep(int, std::unique_ptr<ValueList> values) {
  throw UsageError("a mesh of this type does not keep values for others: \"" + values->name() + "\"");
}

void Mesh::drop(int, const void*) {
  throw UsageError("a mesh of this type does not keep values for others");
}

bool Mesh::has_link_around(LinkSet links, int j, Dart d, int k) const {
  star(d, k, star_);
  for (const Dart t : star_)
    for (const Permutation p : faces_around(dimension_, j, k))
      if (link(links, reorder(t, p)) != no_index) return true;
  return false;
}

void check_simplices_differ(const Mesh& mesh, int k, std::vector<std::string>& problems) {
  std::vector<std::pair<std::array<Index, 4>, Index>> all;
  for (Index s = 0; s < mesh.capacity(k); ++s) {
    if (!mesh.is_live(k, s)) continue;
    std::array<Index, 4> v{no_index, no_index, no_index, no_index};
    mesh.vertices(mesh.dart_of(k, s), v.data());
    std::fill(v.begin() + k + 1, v.end(), no_index);
    std::sort(v.begin(), v.end());
    all.emplace_back(v, s);
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 1; i < all.size(); ++i)
    if (all[i].first == all[i - 1].first)
      problems.push_back(std::string(k == 1   ? "edges "
                                     : k == 2 ? "faces "
                                              : "tetrahedra ") +
                         std::to_string(all[i - 1].second) + " and " + std::to_string(all[i].second) +
                         " have the same vertices");
}

// Each edge is the first one of some triangle, but for the last one of an open fan.
void edges_around(const Mesh& mesh, Dart vertex, DartBuffer& edges) {
  mesh.star(vertex, 0, edges);
  if (!mesh.is_boundary(vertex, 0)) return;
  for (std::size_t i = 0, triangles = edges.size(); i < triangles; ++i) {
    const Dart other = mesh.reorder(edges[i], edge_ax);
    const auto is_other = [&](Dart e) { return mesh.same_simplex(e, other, 1); };
    if (mesh.is_boundary(other, 1) && std::none_of(edges.begin(), edges.end(), is_other))
      edges.push_back(other);
  }
}

Permutation matching(const Index* from, const Index* to, int k) {
  int p[4] = {0, 1, 2, 3};
  for (int i = 0; i <= k; ++i) {
    int j = 0;
    while (j < k && from[j] != to[i]) ++j;
    p[i] = j;
  }
  return permutation(p[0], p[1], p[2], p[3]);
}

Dart dart_with(const Mesh& mesh, Index facet, const Index* vertices) {
  const int d = mesh.dimension();
  const Dart any = mesh.dart_of(d, facet);
  if (any == no_dart) return no_dart;
  std::array<Index, 4> have{};
  mesh.vertices(any, have.data());
  const Dart found = mesh.reorder(any, matching(have.data(), vertices, d));
  mesh.vertices(found, have.data());
  for (int i = 0; i <= d; ++i)
    if (have[static_cast<std::size_t>(i)] != vertices[i]) return no_dart;
  return found;
}

}  // namespace multimesh
