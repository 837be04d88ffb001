// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "oracle/complex.hpp"
#include "oracle/image_signature.hpp"

namespace multimesh::oracle {

/// The result of a collapse by identification.
struct CollapseResult {
  bool valid = false;                      ///< `tree` is a valid tree, see collapse()
  std::string reason;                      ///< why not
  Tree tree;                               ///< after the identification, valid or not
  std::vector<std::map<int, int>> merged;  ///< per node: dead vertex -> the vertex it was identified with
};

/// Collapses the root edge (a,b) in every mesh by nothing but identification: the ends of every edge that
/// lies over (a,b) become one vertex, facets that thereby lose a vertex are dropped, maps follow. No
/// condition is asked beforehand. In the root `a` survives; in the other meshes the smallest vertex of each
/// identified set.
///
///        x                x
///      / | \              |
///     a--+--b   ->      (a=b)     a triangle abx becomes the edge ax = bx
///
/// Not valid afterwards: a mesh without facets, two facets of one mesh with the same vertices, a mesh no
/// longer a manifold, two facets with one image, a vertex without facets (the contraction has a dangling
/// edge there, as when the inner side of an ear is collapsed).
///
/// \pre tree_error(tree) is empty, (a,b) is an edge of the root
CollapseResult collapse(const Tree& tree, int a, int b);

/// The verdict on a collapse.
struct Judgement {
  bool valid = false;      ///< the tree is valid afterwards
  bool unchanged = false;  ///< valid, and image_signature() is what it was
  std::string reason;      ///< what is invalid or has changed
};

/// Judges the collapse of the root edge (a,b). `before` is image_signature(tree, options).
Judgement judge_collapse(const Tree& tree, const TreeSignature& before, int a, int b,
                         const SignatureOptions& options = {});

}  // namespace multimesh::oracle
