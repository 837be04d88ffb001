// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace multimesh {

/// Six times the volume of a tetrahedron, positive if it is positively oriented.
inline double six_volume(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                         const Eigen::Vector3d& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Radians, in [0, pi].
inline double angle_between(const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

/// The angle of the tetrahedron (a,b,x,y) at its edge a-b, radians.
inline double dihedral_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& x,
                             const Eigen::Vector3d& y) {
  const Eigen::Vector3d e = b - a;
  return angle_between(e.cross(x - a), e.cross(y - a));
}

}  // namespace multimesh
