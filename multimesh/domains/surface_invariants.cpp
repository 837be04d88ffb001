// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/surface_invariants.hpp"

#include <algorithm>
#include <array>

namespace multimesh {

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

CopiesStayApart::CopiesStayApart(const Mesh& root, const std::vector<Index>& source)
    : Invariant("copies stay apart"), source_(source) {
  for (Index v = 0; v < root.capacity(0); ++v)
    if (root.is_live(0, v) && root.is_locked(v)) copies_[source[v]].push_back(v);
  std::erase_if(copies_, [](const auto& of_source) { return of_source.second.size() < 2; });
}

// Vertices added later are not copies, whatever source they were given.
std::span<const Index> CopiesStayApart::copies_of(const Index& v) const {
  const auto found = copies_.find(source_[v]);
  const bool is_copy = found != copies_.end() &&
                       std::find(found->second.begin(), found->second.end(), v) != found->second.end();
  return is_copy ? std::span<const Index>(found->second) : std::span(&v, 1);
}

bool CopiesStayApart::joined(const Mesh& mesh, Index v, Index w, Index edge) {
  const std::span<const Index> of_v = copies_of(v), of_w = copies_of(w);
  if (of_v.size() == 1 && of_w.size() == 1) return false;
  for (const Index x : of_v) {
    edges_around(mesh, mesh.dart_of(0, x), around_);
    for (const Dart e : around_)
      if (mesh.simplex(e, 1) != edge &&
          std::find(of_w.begin(), of_w.end(), mesh.vertex(mesh.reorder(e, exchange_ends))) != of_w.end())
        return true;
  }
  return false;
}

bool CopiesStayApart::before(const Event& event) {
  if (event.operation == Operation::collapse) return collapse_allowed(event);
  if (event.operation == Operation::relocate) return true;
  const Mesh& mesh = event.tree.mesh(NodeId::root);
  const Dart e = event.copies[0].dart;
  const auto third = [&](Dart d) { return mesh.vertex(mesh.reorder(d, permutation(2, 0, 1))); };
  if (joined(mesh, mesh.vertex(e), mesh.vertex(mesh.reorder(e, exchange_ends)), mesh.simplex(e, 1)))
    return false;
  return event.operation == Operation::split ||
         !joined(mesh, third(e), third(mesh.switch_dart(e, 2)), no_index);
}

bool CopiesStayApart::collapse_allowed(const Event& event) {
  const Mesh& mesh = event.tree.mesh(NodeId::root);
  Dart stays = event.copies[0].dart, goes = mesh.reorder(stays, exchange_ends);
  if (!mesh.is_locked(mesh.vertex(stays))) std::swap(stays, goes);
  collect_labelled_neighbours(mesh, stays, kept_);
  collect_labelled_neighbours(mesh, goes, gained_);
  const Index merged = mesh.vertex(stays);
  // Faces that meet in an edge with a third one are held together by the fan around its ends, which stays
  // closed.
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
Vec2 SeamsStayOpen::merged(const Event& event, Index vertex) const {
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
  const Index edge = root.simplex(a, 1);
  const auto then = [&](Index v) { return merged(event, v); };
  return (!seam_at_a || open_around(event.tree, a, edge, then)) &&
         (!seam_at_b || event.t >= 1 || open_around(event.tree, root.reorder(a, exchange_ends), edge, then));
}

// Rounding in a split may close a seam, and so may moving a vertex to where charts touch.
bool SeamsStayOpen::after(const Event& event) {
  if (event.operation != Operation::split && event.operation != Operation::relocate) return true;
  if (event.copies.count(texture_) < 2) return true;
  const Dart d = event.copies[0].dart;
  const Dart changed =
      event.operation == Operation::split ? event.tree.mesh(NodeId::root).reorder(d, exchange_ends) : d;
  return open_around(event.tree, changed, no_index, [&](Index v) { return texcoords_[v]; });
}

bool SeamsStayOpen::open_around(const MultiMesh& tree, Dart d, Index without, const Value& near_end) const {
  const Mesh& root = tree.mesh(NodeId::root);
  const Mesh& texture = tree.mesh(texture_);
  edges_around(root, d, star_);
  for (const Dart e : star_) {
    if (root.simplex(e, 1) == without) continue;
    sides_.clear();
    tree.to_child(texture_, e, 1, sides_);
    if (sides_.size() != 2) continue;
    const auto far_end = [&](Dart side) {
      return texcoords_[texture.vertex(texture.reorder(side, exchange_ends))];
    };
    if (far_end(sides_[0]) == far_end(sides_[1]) &&
        near_end(texture.vertex(sides_[0])) == near_end(texture.vertex(sides_[1])))
      return false;
  }
  return true;
}

}  // namespace multimesh
