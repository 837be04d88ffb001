// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "multimesh/openmesh/attach.hpp"

namespace multimesh::openmesh {

/// A user's mesh type. Once driven, its own operations run on the whole tree whose root it is: they hide
/// OpenMesh's operations of the same names. Tools that are templates on the mesh (DecimaterT, McDecimaterT,
/// MixedDecimaterT, LongestEdgeT, smoothers) then change all meshes of the tree, and never use a stale
/// legality:
///
///     openmesh::RootMesh<MyMesh> mesh;
///     openmesh::Attached attached(mesh);
///     mesh.drive(attached);
///     OpenMesh::Decimater::DecimaterT<openmesh::RootMesh<MyMesh>> decimater(mesh);
///
/// A refused operation does nothing; call is_collapse_ok() or is_flip_ok() before, as OpenMesh requires.
/// Functions of the base class, and tools that link halfedges themselves (LoopT, Sqrt3T), bypass this; the
/// tree detects it.
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

  /// Makes the operations those of the tree. Stop driving before the tree is destroyed.
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

  /// With a tree, the next split creates the vertex; a vertex may only be added for a split.
  OpenMesh::SmartVertexHandle add_vertex(const Point& p) {
    if (!tree_) return UserMesh::add_vertex(p);
    place_ = p;
    return OpenMesh::SmartVertexHandle(static_cast<int>(UserMesh::n_vertices()), this);
  }
  /// \pre v was returned by add_vertex() since the last split. \throw UsageError otherwise
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
  /// Inserts a point into a face and joins it to the corners.
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
  // If p is not on the edge, texture coordinates are those of the nearest point on it.
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

  // A copy of the mesh is not the root, and drives no tree.
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
