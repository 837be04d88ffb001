// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::tetgen {

/// Triangles with three different collinear corners, or no higher than the least height. Those connected by
/// edges form one line; it knows which of its points lie on the edges between others.
///
///     a -------- b ---- c     the triangle a, b, c: the edge a-c of its neighbour goes through b
///
class FlatTriangles {
 public:
  /// Unused points do not count. \pre `points` outlives this
  FlatTriangles(std::span<const Point> points, std::span<const std::array<Index, 3>> triangles,
                const std::vector<bool>& used, double least_height);

  /// The points strictly between two corners of a triangle, from a to b. None unless both are on a common
  /// line, and the third corner is not: that triangle would be nearly flat as well.
  std::vector<Index> points_on(Index a, Index b, Index third) const;

 private:
  std::span<const Point> points_;
  double least_height_;
  std::vector<std::vector<Index>> lines_;         // points, by their position on the line
  std::map<Index, std::vector<Index>> lines_at_;  // per point
};

}  // namespace multimesh::tetgen
