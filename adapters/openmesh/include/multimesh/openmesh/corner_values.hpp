// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "multimesh/attribute.hpp"

namespace multimesh::openmesh {

/// A corner of a triangle of the parent, where OpenMesh stores values (the halfedge of the triangle that
/// points to the vertex), and the vertex of the child over it.
struct Corner {
  std::size_t halfedge;
  Index child_vertex;
};

/// Appends the corners below the child's facet at d. \pre the parent is a TriangleMesh, the child of
/// dimension 2
void corners_below(const MultiMesh& tree, NodeId child, Dart d, std::vector<Corner>& out);
/// The corners whose values an operation may have changed: those of the child's facets around its new, merged
/// or moved vertices, or at its swapped edges.
void corners_changed(const Event& event, NodeId child, std::vector<Corner>& out);
/// All corners. Cost: linear
void all_corners(const MultiMesh& tree, NodeId child, std::vector<Corner>& out);

/// Keeps values at the corners of a mesh (OpenMesh's texcoords2D of halfedges) equal to those at the vertices
/// of a child, after each operation, or when write_all() is called.
template <class T>
class CornerValues final : public Attribute {
 public:
  /// `at_vertices`: those of the child; `at_halfedges`: those of its parent.
  CornerValues(const MultiMesh& tree, NodeId child, const std::vector<T>& at_vertices,
               std::vector<T>& at_halfedges)
      : Attribute(child), tree_(tree), at_vertices_(at_vertices), at_halfedges_(at_halfedges) {}

  void update(Operation, const VertexChange&) override {}
  void finish(const Event& event) override {
    corners_.clear();
    corners_changed(event, node(), corners_);
    for (const Corner& c : corners_) {
      T& value = at_halfedges_[c.halfedge];
      if (value == at_vertices_[c.child_vertex]) continue;
      undo_.emplace_back(c.halfedge, value);
      value = at_vertices_[c.child_vertex];
    }
  }
  /// Not undone by a transaction. Cost: linear
  void write_all() {
    corners_.clear();
    all_corners(tree_, node(), corners_);
    for (const Corner& c : corners_) at_halfedges_[c.halfedge] = at_vertices_[c.child_vertex];
  }

  Mark mark() const override { return undo_.size(); }
  void rollback(Mark mark) override {
    for (; undo_.size() > mark; undo_.pop_back())
      if (undo_.back().first < at_halfedges_.size())  // else it was popped with its edge
        at_halfedges_[undo_.back().first] = undo_.back().second;
  }
  void forget() override { undo_.clear(); }

 private:
  const MultiMesh& tree_;
  const std::vector<T>& at_vertices_;
  std::vector<T>& at_halfedges_;
  std::vector<std::pair<std::size_t, T>> undo_;
  std::vector<Corner> corners_;
};

}  // namespace multimesh::openmesh
