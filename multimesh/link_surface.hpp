// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// A triangle of the link of a vertex: one tetrahedron as seen from the vertex.
struct LinkTriangle {
  std::array<Index, 3> vertices{};
  /// Over the edge opposite vertex i: the tetrahedron's side, and the triangle beyond or no_index.
  std::array<Index, 3> sides{}, across{};
};

/// For a link that is a connected surface, without pinches, but neither a sphere nor a disk: sides at which
/// to part it so that it falls into simpler surfaces. They are few: two short paths between two of its rims,
/// or, if it has fewer rims, the edge of a disk.
std::vector<Index> sides_to_part(const std::vector<LinkTriangle>& link);

}  // namespace multimesh
