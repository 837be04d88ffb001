// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

namespace multimesh::test {

using Point = std::array<double, 3>;
using PlainTriangle = std::array<Point, 3>;

/// The distance from a point to a triangle, by projection to its plane and to its edges.
double distance(const Point& p, const PlainTriangle& t);
/// The greatest distance from points of a grid over all triangles of `from` to those of `to`.
double sampled_distance(const std::vector<PlainTriangle>& from, const std::vector<PlainTriangle>& to,
                        int per_edge = 8);

}  // namespace multimesh::test
