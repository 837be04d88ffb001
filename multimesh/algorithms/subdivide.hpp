// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/embedding.hpp"

namespace multimesh {

/// Where the vertices of a subdivided surface go.
enum class Subdivision {
  midpoint,  ///< new ones to the middle of their edges, old ones stay
  loop,  ///< smooth surfaces; lines are smooth curves. Source: Loop 1987, boundary rules of Hoppe et al. 1994
};

struct SubdivideOptions {
  Subdivision scheme = Subdivision::loop;
};

struct SubdivideResult {
  std::size_t splits = 0, swaps = 0, moves = 0;
  /// Edges that are not split, or not swapped, because something in the tree prevents it: the triangles
  /// beside them are divided differently.
  std::size_t refused_splits = 0, refused_swaps = 0;
  /// Vertices that move only part of their way, or not at all, for instance to keep tetrahedra positive.
  std::size_t shortened_moves = 0, refused_moves = 0;
  /// Tetrahedra with several faces on the surface: a vertex was inserted into each, so that its faces can be
  /// divided.
  std::size_t split_tets = 0;
};

// clang-format off
/// Divides every triangle of a surface into four, anywhere in a tree: each edge is split, and the edges that
/// join an old and a new vertex inside a triangle are swapped.
///
///          c                 c
///         / \               / \        Curves below: every edge becomes two. Charts below: the same rules by
///        /   \      ->     m---m       their own neighbours, on each side of a seam by those of that side.
///       /     \           / \ / \      Tetrahedra around follow, and vertices go no farther than these allow.
///      a-------b         a---m---b
///
/// Curves of the tree (boundaries, seams, creases, the sides of a tile) are creases of `loop`; vertices where they
/// end, meet or change stay where they are, as do locked ones. An exception rolls back the whole subdivision.
/// \throw UsageError if the mesh is not a surface or has no coordinates in space. Cost: linear
// clang-format on
SubdivideResult subdivide(const Embedding& embedding, NodeId surface, const SubdivideOptions& options = {});

}  // namespace multimesh
