// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/improvement/flatness.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>

#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/geometry/tet_shape.hpp"

namespace multimesh::improvement {

namespace {

/// Distances of points whose coordinates are rounded a few times.
double rounding_of(std::initializer_list<const Vec3*> points) {
  constexpr double units = 4;
  double largest = 0;
  for (const Vec3* p : points)
    for (const double x : *p) largest = std::max(largest, std::abs(x));
  return units * std::numeric_limits<double>::epsilon() * largest;
}

double doubled_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return cross(b - a, c - a).norm();
}

}  // namespace

// The smallest height of the tetrahedron is that over its largest face.
bool Flatness::coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const {
  const double volume = std::abs(six_volume(a, b, c, d));
  // Where rounding cannot have made this of a volume of 0, the exact sign need not be asked.
  constexpr double surely = 0x1p-48;
  const bool may_be_flat = !(volume > surely * (b - a).norm() * (c - a).norm() * (d - a).norm());
  if (rounded) {
    const double area = std::max(
        {doubled_area(a, b, c), doubled_area(a, b, d), doubled_area(a, c, d), doubled_area(b, c, d)});
    if (volume <= area * rounding_of({&a, &b, &c, &d})) return true;
  }
  return may_be_flat && orient3d(a.data(), b.data(), c.data(), d.data()) == 0;
}

bool Flatness::collinear(const Vec3& a, const Vec3& b, const Vec3& c) const {
  if (multimesh::collinear(a.data(), b.data(), c.data())) return true;
  if (!rounded) return false;
  const double longest = std::max({(b - a).norm(), (c - a).norm(), (c - b).norm()});
  return doubled_area(a, b, c) <= longest * rounding_of({&a, &b, &c});
}

}  // namespace multimesh::improvement
