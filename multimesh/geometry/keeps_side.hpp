// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>

#include "multimesh/geometry/orient2d.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh {

/// The corners of a triangle, in the plane or in space.
template <std::size_t N>
using Corners = std::array<Vec<N>, 3>;

/// The side of a triangle of the plane: the exact sign of its orientation. Of N coordinates, the first two
/// count.
template <std::size_t N>
int side_of(const Corners<N>& t) {
  return orient2d(t[0].data(), t[1].data(), t[2].data());
}

/// Twice its area, rounded; negative on the right side.
template <std::size_t N>
double doubled_area(const Corners<N>& t) {
  const double ux = t[1][0] - t[0][0], uy = t[1][1] - t[0][1];
  const double vx = t[2][0] - t[0][0], vy = t[2][1] - t[0][1];
  return ux * vy - uy * vx;
}

/// How a triangle of the plane may change. It keeps its side, or comes to the side that is right; and it does
/// not vanish: one that can be seen can be seen afterwards.
struct KeepsSide {
  /// A doubled area that cannot be seen, relative to the squared diagonal of the bounding box.
  static constexpr double relative_no_area = 1e-11;

  double no_area = 0;  ///< the largest doubled area that cannot be seen

  /// \param right 1 or -1; 0: no side is
  template <std::size_t N>
  bool operator()(const Corners<N>& before, const Corners<N>& after, int right) const {
    const int has = side_of(after);
    if ((right == 0 || has != right) && has != side_of(before)) return false;
    return std::abs(doubled_area(before)) <= no_area || std::abs(doubled_area(after)) > no_area;
  }
};

/// An area vector, twice as long as the area: the normal of the triangle.
inline Vec3 doubled_area_vector(const Corners<3>& t) {
  return cross(t[1] - t[0], t[2] - t[0]);
}

/// How a triangle in space may change: whether its normal, of any length, turns at most by an angle, given by
/// its cosine.
inline bool turns_at_most(double least_cosine, const Vec3& before, const Vec3& after) {
  return dot(before, after) >= least_cosine * std::sqrt(before.squared_norm() * after.squared_norm());
}

}  // namespace multimesh
