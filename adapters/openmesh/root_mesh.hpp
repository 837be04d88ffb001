// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "multimesh/openmesh/attach.hpp"

namespace multimesh::openmesh {

/// A mesh type of the user's whose own operations are, once it is told so, those of the tree that it is the
/// root of: the names of OpenMesh's operations are hidden. Tools that are templates on the mesh (DecimaterT,
/// McDecimaterT, MixedDecimaterT, LongestEdgeT, smoothers) then change all meshes of the tree, and never see
/// a stale legality:
///
///     openmesh::RootMesh<MyMesh> mesh;
///     openmesh::Attached attached(mesh);
///     mesh.drive(attached);
///     OpenMesh::Decimater::DecimaterT<openmesh::RootMesh<MyMesh>> decimater(mesh);
///
/// A refused operation does nothing; ask is_collapse_ok() or is_flip_ok() before, as OpenMesh wants it.
/// Functions of the base class, and tools that link halfedges by themselves (LoopT, Sqrt3T), pass this by:
/// the tree notices.
template <class UserMesh>
class RootMesh : public UserMesh {
 public:
  using UserMesh::UserMesh;
  using VertexHandle = OpenMesh::VertexHandle;
  using HalfedgeHandle = OpenMesh::HalfedgeHandle;
  using EdgeHandle = OpenMesh::EdgeHandle;
  using FaceHandle = OpenMesh::FaceHandle;
  using Point = typename UserMesh::Point;
  using Tree = Attached<RootMesh>;

  /// From now on operations are those of the tree; it must be driven no more before it goes.
  void drive(Tree& tree) noexcept { tree_.pointer = &tree; }
  void drive_no_more() noexcept { tree_.pointer = nullptr; }
  /// How many operations the tree has refused.
  std::size_t refused() const noexcept { return refused_; }

  bool is_collapse_ok(HalfedgeHandle h) {
    if (!tree_) return UserMesh::is_collapse_ok(h);
    if (UserMesh::status(UserMesh::edge_handle(h)).deleted()) return false;
    return !tree_->operations().why_not_collapse(NodeId::root, tree_->dart(h), Placement::keep_b()).refused();
  }
  void collapse(HalfedgeHandle h) {
    if (!tree_) return UserMesh::collapse(h);
    note(tree_->collapse(h));
  }
  bool is_flip_ok(EdgeHandle e) const {
    if (!tree_) return UserMesh::is_flip_ok(e);
    if (UserMesh::status(e).deleted()) return false;
    return !tree_->operations().why_not_swap(NodeId::root, tree_->dart(e)).refused();
  }
  void flip(EdgeHandle e) {
    if (!tree_) return UserMesh::flip(e);
    note(tree_->swap(e));
  }

  /// Under a tree a vertex comes to be by the split that it is added for: the next one.
  OpenMesh::SmartVertexHandle add_vertex(const Point& p) {
    if (!tree_) return UserMesh::add_vertex(p);
    place_ = p;
    return OpenMesh::SmartVertexHandle(static_cast<int>(UserMesh::n_vertices()), this);
  }
  /// \pre v is what add_vertex() has given since the last split. \throw UsageError if it is not
  void split(EdgeHandle e, VertexHandle v) {
    if (!tree_) return UserMesh::split(e, v);
    if (v.idx() != static_cast<int>(UserMesh::n_vertices()))
      throw UsageError("vertex " + std::to_string(v.idx()) +
                       " exists already; under a tree an edge is split at a vertex that was just added");
    split_at(e, place_);
  }
  void split_copy(EdgeHandle e, VertexHandle v) { tree_ ? split(e, v) : UserMesh::split_copy(e, v); }
  OpenMesh::SmartVertexHandle split(EdgeHandle e, const Point& p) {
    if (!tree_) return UserMesh::split(e, p);
    return split_at(e, p);
  }
  /// Joins a point of a face to its corners.
  OpenMesh::SmartVertexHandle split(FaceHandle f, const Point& p) {
    if (!tree_) return UserMesh::split(f, p);
    const Outcome o = tree_->operations().split_simplex(NodeId::root, tree_->dart(f), 2);
    if (!note(o)) return OpenMesh::SmartVertexHandle();
    const VertexHandle v(static_cast<int>(tree_->tree().mesh(NodeId::root).vertex(o.dart)));
    note(tree_->relocate(v, p));
    return OpenMesh::SmartVertexHandle(v.idx(), this);
  }

  void garbage_collection() { tree_ ? tree_->garbage_collection() : UserMesh::garbage_collection(); }
  void garbage_collection(std::vector<VertexHandle*>& v, std::vector<HalfedgeHandle*>& h,
                          std::vector<FaceHandle*>& f) {
    tree_ ? tree_->garbage_collection({v, h, {}, f}) : UserMesh::garbage_collection(v, h, f);
  }

 private:
  bool note(const Outcome& o) {
    refused_ += !o;
    return bool(o);
  }
  // Where p is beside the edge, texture coordinates are those of the nearest point on it.
  OpenMesh::SmartVertexHandle split_at(EdgeHandle e, const Point& p) {
    const HalfedgeHandle h = UserMesh::halfedge_handle(e, 0);
    const Point from = UserMesh::point(UserMesh::from_vertex_handle(h));
    const Point along = UserMesh::point(UserMesh::to_vertex_handle(h)) - from;
    const double length2 = double(along.sqrnorm());
    const double t = length2 > 0 ? double((p - from) | along) / length2 : 0.5;
    const Outcome o = tree_->split(e, std::clamp(t, 0.0, 1.0));
    if (!note(o)) return OpenMesh::SmartVertexHandle();
    const VertexHandle v = UserMesh::to_vertex_handle(tree_->halfedge(o.dart));
    if (UserMesh::point(v) != p) note(tree_->relocate(v, p));
    return OpenMesh::SmartVertexHandle(v.idx(), this);
  }

  // A copy of the mesh, which is not the root, drives no tree.
  struct DrivenTree {
    DrivenTree() = default;
    DrivenTree(const DrivenTree&) noexcept {}
    DrivenTree& operator=(const DrivenTree&) noexcept { return *this; }
    explicit operator bool() const noexcept { return pointer != nullptr; }
    Tree* operator->() const noexcept { return pointer; }
    Tree* pointer = nullptr;
  };

  DrivenTree tree_;
  Point place_{};
  std::size_t refused_ = 0;
};

}  // namespace multimesh::openmesh
