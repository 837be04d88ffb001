// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "multimesh/build.hpp"
#include "multimesh/operations.hpp"
#include "test/support/point3.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {

/// A tree with a position on the vertices of every mesh. The children's start as copies of the root's and
/// then follow the operations on their own: if they ever differ from those of their images, an operation
/// placed copies of one vertex at different points.
class Tree {
 public:
  explicit Tree(const Shape& root);

  NodeId add(NodeId id);  ///< gives a mesh that was just added its positions
  /// A child over all facets, cut open along the given sides of facets.
  NodeId add_cut(NodeId parent, const std::function<bool(Index side)>& seam);
  NodeId add_tagged(NodeId parent, int k, const std::function<bool(Index)>& tagged, const CutOptions& = {});
  NodeId add_boundary(NodeId parent);

  /// Relocates a vertex, in every mesh that has it.
  Outcome move(NodeId n, Dart v, const Point3& by);

  const std::vector<Point3>& points(NodeId n) const { return *points_[index(n)]; }
  VertexAttribute<Point3>& attribute(NodeId n) { return *attributes_[index(n)]; }

  std::unique_ptr<MultiMesh> tree;
  std::unique_ptr<Propagation> operations;

 private:
  std::vector<std::unique_ptr<VertexAttribute<Point3>>> attributes_;
  std::vector<std::vector<Point3>*> points_;
};

/// A name and how to make the tree, with about `size` facets in the root.
struct TreeKind {
  std::string name;
  std::function<std::unique_ptr<Tree>(Index size, unsigned seed)> make;
  friend void PrintTo(const TreeKind& k, std::ostream* out) { *out << k.name; }
};

/// Below a surface: UV; UV + seam curves below the UV; boundary + feature curves; UV of UV, three deep;
/// curves below curves; a torus with its square tile; points on the surface, on its UV, on curves and on the
/// ends of those.
const std::vector<TreeKind>& surface_tree_kinds();

/// Below curves: points, and some of the edges with points.
const std::vector<TreeKind>& curve_tree_kinds();

/// Below a tetrahedral mesh: its boundary; a closed surface; an open one + its boundary; two that meet in
/// curves + those; boundary + curves on it and beside it; any triangles and edges; a part + its boundary +
/// curves, three deep; all of it cut open + parts; the 3-torus with its cube and the surface of that; points
/// on it, on a part, on a surface and on a curve of that, three deep.
const std::vector<TreeKind>& solid_tree_kinds();

/// All kinds that the random tests run on.
const std::vector<TreeKind>& tree_kinds();

}  // namespace multimesh::test
