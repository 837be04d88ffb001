// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// A UV-like child: the given facets of the parent, facet for facet, with corners merged only across edges
/// that are not cut. Always a manifold. An edge cut on both sides of which the same vertices remain (a slit
/// of one edge) has only one copy in a simplicial complex, hence is not cut.
///
/// \pre dim 2, `facets` not empty
TreeNode surface_child(const Complex& parent, int parent_index, const std::vector<std::size_t>& facets,
                       const SimplexSet& cuts);

/// An edge-mesh child of the given edges of the parent (dim 1 or 2), cut at every vertex in other than two of
/// them and at `cut_at`: one child vertex per edge there. Loops without such vertices stay closed.
///
/// \pre `edges` not empty
TreeNode curve_child(const Complex& parent, int parent_index, const SimplexSet& edges,
                     const std::vector<int>& cut_at = {});

/// A child of points over vertices of the parent, one each.
///
/// \pre `over` not empty, without duplicates
TreeNode point_child(int parent_index, const std::vector<int>& over);

/// A child of dimension 1 or more over k-simplices of the parent, whose corners are merged only across sides
/// that lie in exactly two of them and are not cut. Not a manifold if copies of a side have the same ends, or
/// a vertex of a solid is not inside a ball: ask tree_error().
///
/// \pre `over` not empty, of one dimension
TreeNode cut_child(int parent_index, const SimplexSet& over, const SimplexSet& cuts = {});

/// The cut graph of a surface child in a host, and its special vertices.
struct SeamGraph {
  SimplexSet edges;          ///< seams (two preimages), and edges between covered and uncovered facets
  std::vector<int> corners;  ///< vertices where it is not locally one curve of one kind, ascending
};

/// The cut graph of a node in one of its ancestors. Cut at its corners, a curve child of these edges is the
/// guard (G) of the design.
///
/// \pre both of dim 2
SeamGraph seam_graph(const Tree& tree, int node, int host);

/// The edges of a node over given edges of an ancestor, and its vertices over given vertices.
SimplexSet edges_over(const Tree& tree, int node, int host, const SimplexSet& edges);
std::vector<int> vertices_over(const Tree& tree, int node, int host, const std::vector<int>& points);

}  // namespace multimesh::oracle
