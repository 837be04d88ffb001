// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <span>
#include <vector>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::tetgen {

/// Triangles with three different corners on a line, or no higher than the least height. Those that hang
/// together by edges are taken for one line; it says which of their points lie on the edges between others.
///
///     a -------- b ---- c     the triangle a, b, c: the edge a-c of its neighbour goes through b
///
class FlatTriangles {
 public:
  /// Points that are not used do not count. \pre `points` outlives this
  FlatTriangles(std::span<const Point> points, std::span<const std::array<Index, 3>> triangles,
                const std::vector<bool>& used, double least_height);

  /// The points strictly between two corners of a triangle, from a to b; none unless both are on a line
  /// together, and the third corner is not: that would be flat as well, nearly.
  std::vector<Index> points_on(Index a, Index b, Index third) const;

 private:
  std::span<const Point> points_;
  double least_height_;
  std::vector<std::vector<Index>> lines_;         // points, by their place on the line
  std::map<Index, std::vector<Index>> lines_at_;  // per point
};

}  // namespace multimesh::tetgen
