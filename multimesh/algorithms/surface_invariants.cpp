// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/surface_invariants.hpp"

#include <algorithm>
#include <array>

namespace multimesh {

using OpenMesh::Vec2d;

void CopiesStayApart::collect_labelled_neighbours(const Mesh& mesh, Dart vertex, std::vector<Index>& out) {
  out.clear();
  mesh.star(vertex, 0, star_);
  for (const Dart d : star_) {
    std::array<Index, 4> v{};
    mesh.vertices(d, v.data());
    for (const Index x : {v[1], v[2]})
      if (mesh.is_locked(x) && std::find(out.begin(), out.end(), x) == out.end()) out.push_back(x);
  }
}

bool CopiesStayApart::before(const Event& event) {
  if (event.operation != Operation::collapse) return true;
  const Mesh& mesh = event.tree.mesh(NodeId::root);
  Dart stays = event.copies[0].dart, goes = mesh.reorder(stays, exchange_ends);
  if (!mesh.is_locked(mesh.vertex(stays))) std::swap(stays, goes);
  collect_labelled_neighbours(mesh, stays, kept_);
  collect_labelled_neighbours(mesh, goes, gained_);
  const Index merged = mesh.vertex(stays);
  // Faces that meet in an edge with a third one are held together by the fan around its ends: it stays closed.
  if (mesh.is_locked(merged) && !mesh.is_boundary(stays, 0) && mesh.is_boundary(goes, 0)) return false;
  std::erase_if(gained_, [&](Index x) {
    return x == merged || std::find(kept_.begin(), kept_.end(), x) != kept_.end();
  });
  if (mesh.is_locked(merged)) {
    if (!gained_.empty()) return false;  // an edge of two copies: another sheet may have it
    mesh.star(goes, 0, around_);         // a vertex that has an edge with another copy of the merged one
    for (const Dart d : around_)
      for (const Permutation neighbour : {exchange_ends, permutation(2, 0, 1)}) {
        const Dart at = mesh.reorder(d, neighbour);
        if (mesh.vertex(at) == merged) continue;
        collect_labelled_neighbours(mesh, at, other_);
        for (const Index x : other_)
          if (x != merged && source_[x] == source_[merged]) return false;
      }
    return true;
  }
  return std::none_of(gained_.begin(), gained_.end(), [&](Index x) {
    return std::any_of(kept_.begin(), kept_.end(), [&](Index y) { return source_[x] == source_[y]; });
  });
}

// The texture coordinates that a vertex of the texture will have.
Vec2d SeamsStayOpen::merged(const Event& event, Index vertex) const {
  const std::size_t first = event.copies.first(texture_);
  for (std::size_t i = first; i < first + event.copies.count(texture_); ++i) {
    const VertexChange change = event.collapse_of(i);
    if (vertex == change.a || vertex == change.b) return texcoords_.result(Operation::collapse, change);
  }
  return texcoords_[vertex];
}

bool SeamsStayOpen::before(const Event& event) {
  if (event.operation != Operation::collapse) return true;
  const Mesh& texture = event.tree.mesh(texture_);
  const Mesh& root = event.tree.mesh(NodeId::root);
  const Dart a = event.copies[0].dart;
  bool seam_at_a = false, seam_at_b = false;
  for (const Copy& c : event.copies.of(texture_)) {
    seam_at_a |= texture.is_boundary(c.dart, 0);
    seam_at_b |= texture.is_boundary(texture.reorder(c.dart, exchange_ends), 0);
  }
  return (!seam_at_a || open_around(event, a)) &&
         (!seam_at_b || event.t >= 1 || open_around(event, root.reorder(a, exchange_ends)));
}

bool SeamsStayOpen::open_around(const Event& event, Dart end) const {
  const Mesh& root = event.tree.mesh(NodeId::root);
  const Mesh& texture = event.tree.mesh(texture_);
  const Index edge = root.simplex(event.copies[0].dart, 1);
  root.star(end, 0, star_);
  for (const Dart d : star_) {
    if (root.simplex(d, 1) == edge) continue;
    sides_.clear();
    event.tree.to_child(texture_, d, 1, sides_);
    if (sides_.size() != 2) continue;
    const auto near_end = [&](Dart side) { return merged(event, texture.vertex(side)); };
    const auto far_end = [&](Dart side) {
      return texcoords_[texture.vertex(texture.reorder(side, exchange_ends))];
    };
    if (far_end(sides_[0]) == far_end(sides_[1]) && near_end(sides_[0]) == near_end(sides_[1])) return false;
  }
  return true;
}

}  // namespace multimesh
