// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "multimesh/coordinates.hpp"

namespace multimesh {

/// Where the vertices of a subdivided surface go.
enum class Subdivision {
  midpoint,  ///< new ones to the middle of their edges, old ones stay
  loop,  ///< smooth surfaces; lines are smooth curves. Source: Loop 1987, boundary rules of Hoppe et al. 1994
};

/// Divides every triangle into four, in all meshes of a tree: each edge is split, and the edges that join an
/// old and a new vertex inside a triangle are swapped.
///
///          c                 c
///         / \               / \        In curves below, every edge becomes two.
///        /   \      ->     m---m       Lines of the tree (boundaries, seams, curves) are creases of `loop`;
///        vertices
///       /     \           / \ / \      where lines end, meet or change stay where they are, as do locked
///       ones.
///      a-------b         a---m---b
///
/// `positions`: of the root, of dimension 2, over OpenMesh; `below`: coordinates of its children of dimension
/// 2, which get the same rules by their own neighbours, on both sides of a seam by their own. `operations`
/// must have the attributes of all of them; others follow by interpolation. Undone as a whole by an
/// exception, or within a transaction. \throw UsageError if the root is no surface over OpenMesh. Cost:
/// linear
void subdivide(Propagation& operations, Coordinates& positions, std::span<Coordinates* const> below,
               Subdivision scheme);

}  // namespace multimesh
