// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// The result of a split.
struct SplitResult {
  Tree tree;
  std::vector<std::map<Simplex, int>> vertex;  ///< per node: split edge -> its new vertex
};

/// Splits the root edge (a,b), and every edge over it, at a new vertex; every facet on such an edge becomes
/// two. New vertices are numbered from 1 + the largest vertex of their mesh, edges in ascending order.
///
///        x                x
///      /   \            / | \           .
///     a-----b   ->     a--c--b
///
/// Always valid and never changes image_signature().
///
/// \pre tree_error(tree) is empty, (a,b) is an edge of the root
SplitResult split(const Tree& tree, int a, int b);

}  // namespace multimesh::oracle
