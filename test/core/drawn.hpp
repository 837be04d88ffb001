// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>

#include "test/core/bridge.hpp"

/// Trees drawn by hand, for tests that name their vertices.
namespace multimesh::test {

using Triangle = std::array<Index, 3>;
using Segment = std::array<Index, 2>;

FacetList triangles(std::initializer_list<Triangle> list);
FacetList segments(std::initializer_list<Segment> list);

/// Positions are arbitrary but distinct.
Tree drawn(std::initializer_list<Triangle> root);

/// A child with these facets; image[v] is the parent's vertex under its vertex v.
NodeId add_drawn(Tree& tree, NodeId parent, const FacetList& child, std::initializer_list<Index> image);

/// Facets by their vertices: each facet sorted, then all of them.
std::vector<std::vector<Index>> sorted_facets(const Mesh& mesh);

/// The edge dart (a, b) of a mesh. Fails the test if there is none.
Dart edge(const Tree& tree, NodeId n, Index a, Index b);

/// The triangles
///         3---0---4
///          \ / \ /
///           1---2        two_neighbors: (0,1,2), (3,1,0), (0,2,4)
Tree two_neighbors();

/// The child with the same triangles, the second one apart: the seam 0-1.
///     6---5   0---4
///      \ /   / \ /
///       3   1---2
NodeId add_cut_on_edge01(Tree& tree, NodeId parent);

/// two_neighbors and (3,0,4): vertex 0 is interior.
Tree two_neighbors_plus_one();

/// The fan of n triangles around vertex 0, closed, with its triangles cut apart as a child.
Tree disk_to_individual(Index n);

}  // namespace multimesh::test
