// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace multimesh::improvement {

namespace {

double two_thirds(double x) {
  return std::isfinite(x) ? std::cbrt(x * x) : std::numeric_limits<double>::infinity();
}

}  // namespace

// The free corner lies above the centroid, which minimizes the sum of the squared distances at each height h;
// that is S/3 + 3 h^2, and h^2 = 2 S / 9 minimizes the energy.
double least_amips_over(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double squares = (b - a).squared_norm() + (c - b).squared_norm() + (a - c).squared_norm();
  const double area = cross(b - a, c - a).norm() / 2;
  return area > 0 ? two_thirds(0.75 * squares / area) : std::numeric_limits<double>::infinity();
}

// An edge of length 1; the other corners at its middle, at equal distances r with r^2 (1 + s^2) = 1, where s
// is the sine of half the angle.
double least_amips_at_dihedral(double angle) {
  const double regular = std::acos(1.0 / 3);
  const double phi = std::clamp(angle, 0.0, regular);
  const double s = std::sin(phi / 2), volume = std::numbers::sqrt2 * std::sin(phi);
  return volume > 0 ? 3 * two_thirds((1 + s * s) / volume) : std::numeric_limits<double>::infinity();
}

// The triangle with equal sides at the angle has the least S / A among those with the angle.
double least_amips_at_corner(double angle) {
  const double phi = std::clamp(angle, 0.0, std::numbers::pi / 3);
  const double area = std::sin(phi) / 2;
  return area > 0 ? two_thirds(0.75 * (4 - 2 * std::cos(phi)) / area)
                  : std::numeric_limits<double>::infinity();
}

}  // namespace multimesh::improvement
