// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// The composed vertex map from a node to one of its ancestors (itself: the identity).
/// \throw std::logic_error if `ancestor` is none
std::map<int, int> map_to(const Tree& tree, int node, int ancestor);

/// The image of a node's mesh in an ancestor: a subcomplex, closed under faces.
SimplexSet image(const Tree& tree, int node, int ancestor);

/// The simplices of `mesh` that the vertex map sends onto `s`, without loss of dimension.
SimplexSet preimages(const Complex& mesh, const std::map<int, int>& map, const Simplex& s);
/// The simplices of a node that lie over the simplex `s` of an ancestor.
SimplexSet preimages(const Tree& tree, int node, int ancestor, const Simplex& s);

/// Why `map` is no containment map from child to parent: a vertex without image, a facet whose image is
/// degenerate or no simplex of the parent, two facets with one image, a key that is no vertex. Empty if
/// valid.
std::string map_error(const Complex& child, const Complex& parent, const std::map<int, int>& map);

/// The first error of a tree: order of nodes, a mesh that is no manifold, an invalid map. Names the node.
/// Empty if valid.
std::string tree_error(const Tree& tree);

}  // namespace multimesh::oracle
