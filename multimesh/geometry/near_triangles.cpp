// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/geometry/near_triangles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace multimesh::spatial {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Of length 1; 0 stays 0.
Vec3 unit(const Vec3& p) {
  const double length = p.norm(), factor = length > 0 ? 1 / length : 0;
  return p * factor;
}

}  // namespace

NearTriangles::Entry NearTriangles::entry(Index name, const Triangle& t) {
  Entry e{name, t, {}, {}, false};
  const std::array<Vec3, 3> edge{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  const Vec3 normal = cross(edge[0], edge[1]);
  const double longest = std::max({dot(edge[0], edge[0]), dot(edge[1], edge[1]), dot(edge[2], edge[2])});
  e.is_fat = dot(normal, normal) > 1e-4 * longest * longest;
  e.normal = unit(normal);
  for (std::size_t i = 0; i < 3; ++i) e.outward[i] = unit(cross(edge[i], e.normal));
  return e;
}

void NearTriangles::add(Index name, const Triangle& t) {
  entries_[size_++] = entry(name, t);
}

/// Infinite if the triangle's plane or the planes through its edges show that p is not near. Errors of that
/// test are on the safe side only. Most points are far from the triangle or straight above it.
double NearTriangles::squared_distance(const Entry& e, const Vec3& p) const {
  const double limit = distance_ * (1 + 1e-9);
  bool is_above = e.is_fat;
  for (std::size_t i = 0; i < 3; ++i) {
    const double outside = dot(e.outward[i], p - e.triangle[i]);
    if (outside > limit) return infinity;
    is_above &= outside <= 0;
  }
  const double height = dot(e.normal, p - e.triangle[0]);
  if (std::abs(height) > limit) return infinity;
  return is_above ? height * height : closest_point(p, e.triangle).squared_distance;
}

NearTriangles::Near NearTriangles::near(const Vec3& p, std::size_t first) const {
  Near found;
  double least = infinity;
  for (std::size_t i = first; i < size_; ++i) {
    const double d = squared_distance(entries_[i], p);
    if (!(d <= squared_distance_)) continue;
    found.mask |= Mask{1} << i;
    if (d < least) least = d, found.nearest = i;
  }
  return found;
}

double NearTriangles::leaves(const Entry& e, const Vec3& p, const Vec3& q) {
  double t = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    const double at_p = dot(e.outward[i], p - e.triangle[i]);
    const double at_q = dot(e.outward[i], q - e.triangle[i]);
    if (at_q > 0) t = std::min(t, at_p < 0 ? at_p / (at_p - at_q) : 0);
  }
  return t;
}

double NearTriangles::leaves(Mask triangles, const Vec3& p, const Vec3& q) const {
  double t = 0;
  for (; triangles != 0; triangles &= triangles - 1)
    t = std::max(t, leaves(entries_[static_cast<std::size_t>(std::countr_zero(triangles))], p, q));
  return t;
}

}  // namespace multimesh::spatial
