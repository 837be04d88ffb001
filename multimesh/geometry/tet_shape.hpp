// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "multimesh/geometry/vector.hpp"

namespace multimesh {

/// Six times the volume of a tetrahedron, positive if it is positively oriented.
inline double six_volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(cross(b - a, c - a), d - a);
}

/// Radians, in [0, pi].
inline double angle_between(const Vec3& u, const Vec3& v) {
  return std::atan2(cross(u, v).norm(), dot(u, v));
}

/// The angle of the tetrahedron (a,b,x,y) at its edge a-b, radians.
inline double dihedral_angle(const Vec3& a, const Vec3& b, const Vec3& x, const Vec3& y) {
  const Vec3 e = b - a;
  return angle_between(cross(e, x - a), cross(e, y - a));
}

}  // namespace multimesh
