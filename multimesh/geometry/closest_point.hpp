// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::spatial {

/// In space, or in the plane z = 0.
using Triangle = std::array<Vec3, 3>;

/// A point of a triangle: weights of the corners, none negative, sum 1.
struct PointOnTriangle {
  std::array<double, 3> barycentric{1, 0, 0};
  double squared_distance = 0;  ///< to the query point
};

/// The point of the triangle that is closest to p. Triangles without area are treated as segments or points.
/// Error of the distance: a few roundings of the distance from p to the farthest corner.
PointOnTriangle closest_point(const Vec3& p, const Triangle& triangle);

/// The point of the triangle with these weights.
inline Vec3 at(const Triangle& t, const std::array<double, 3>& w) {
  Vec3 p{};
  for (std::size_t i = 0; i < 3; ++i) p[i] = w[0] * t[0][i] + w[1] * t[1][i] + w[2] * t[2][i];
  return p;
}

}  // namespace multimesh::spatial
