// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/tree_strata.hpp"

#include <algorithm>
#include <array>

namespace multimesh {

bool TreeStrata::is_locked(Dart vertex) const {
  if (mesh_.is_locked(mesh_.vertex(vertex))) return true;
  if (node_ == NodeId::root) return false;
  const Mesh& root = tree_.mesh(NodeId::root);
  return root.is_locked(root.vertex(tree_.to_root(node_, vertex)));
}

EdgeKind TreeStrata::kind(Dart e) {
  if (numbers_ && (*numbers_)[mesh_.simplex(e, 1)] == 0) return {};
  copies_.collect(tree_, node_, e, 1);
  EdgeKind kind;
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    if (mesh.dimension() > 2) continue;
    const std::span<const Copy> here = copies_.of(n);
    // A seam may be interior in its mesh: where two sheets have the edge.
    for (const Copy& c : here)
      if (mesh.dimension() == 1 || here.size() > 1 || mesh.is_boundary(c.dart, 1))
        kind.meshes_.push_back(index(n));
  }
  return kind;
}

Freedom TreeStrata::freedom(Dart vertex, std::array<Dart, 2>& line) {
  if (is_locked(vertex)) return Freedom::none;
  edges_around(mesh_, vertex, edges_);
  EdgeKind first;
  int n = 0;
  for (const Dart e : edges_) {
    EdgeKind k = kind(e);
    if (k.is_plain()) continue;
    if (n == 2 || (n == 1 && !(k == first))) return Freedom::none;
    line[static_cast<std::size_t>(n++)] = e;
    if (n == 1) first = std::move(k);
  }
  if (n == 1 || !runs_through(vertex, first)) return Freedom::none;
  return n == 0 ? Freedom::surface : Freedom::line;
}

// In every mesh the vertex has as many copies as each of its two edges; no curve ends there, and it is no point.
bool TreeStrata::runs_through(Dart vertex, const EdgeKind& kind) {
  copies_.collect(tree_, node_, vertex, 0);
  for (const NodeId n : tree_.nodes()) {
    const auto of_edge =
        static_cast<std::uint32_t>(std::count(kind.meshes_.begin(), kind.meshes_.end(), index(n)));
    const std::span<const Copy> here = copies_.of(n);
    const Mesh& mesh = tree_.mesh(n);
    for (const Copy& c : here)
      if (mesh.dimension() == 0 || mesh.is_locked(mesh.vertex(c.dart))) return false;
    if (mesh.dimension() == 1) {
      if (here.size() != of_edge) return false;
      for (const Copy& c : here)
        if (mesh.is_boundary(c.dart, 0)) return false;
    } else if (mesh.dimension() == 2 && (of_edge > 0 ? here.size() != of_edge : here.size() > 1)) {
      return false;
    }
  }
  return true;
}

}  // namespace multimesh
