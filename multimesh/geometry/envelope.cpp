// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/geometry/envelope.hpp"

#include <algorithm>
#include <limits>

namespace multimesh::spatial {

namespace {

constexpr double slack = 1 + 1e-12;        // for rounding, relative to the distance
constexpr double smallest_part = 1.0 / 8;  // of the distance

}  // namespace

Envelope::Envelope(std::vector<Triangle> surface, double distance)
    : triangles_(std::move(surface)),
      tree_(triangles_),
      distance_(distance),
      squared_distance_(distance * distance * slack),
      smallest_(smallest_part * distance * smallest_part * distance) {}

Envelope::Near Envelope::near(const Vec3& p) const {
  Near found;
  tree_.visit_near(p, squared_distance_, [&](Index t) {
    if (found.size < Near::room && closest_point(p, triangles_[t]).squared_distance <= squared_distance_)
      found.triangles[found.size++] = t;
    return found.size < Near::room ? squared_distance_ : -1;
  });
  std::sort(found.triangles.begin(), found.triangles.begin() + static_cast<std::ptrdiff_t>(found.size));
  return found;
}

Vec3 Envelope::closest(const Vec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  Vec3 place{};
  tree_.visit_near(p, least, [&](Index t) {
    const PointOnTriangle q = closest_point(p, triangles_[t]);
    if (q.squared_distance < least) least = q.squared_distance, place = at(triangles_[t], q.barycentric);
    return least;
  });
  return place;
}

bool Envelope::contains(const Triangle& t) const {
  std::array<Corner, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    corners[i] = {t[i], near(t[i])};
    if (corners[i].near.size == 0) return false;
  }
  return contains(corners[0], corners[1], corners[2]);
}

bool Envelope::contains(const Corner& a, const Corner& b, const Corner& c) const {
  const auto has = [](const Near& near, Index t) {
    return std::binary_search(near.triangles.begin(),
                              near.triangles.begin() + static_cast<std::ptrdiff_t>(near.size), t);
  };
  for (std::size_t i = 0; i < a.near.size; ++i)
    if (has(b.near, a.near.triangles[i]) && has(c.near, a.near.triangles[i])) return true;
  const double ab = (a.position - b.position).squared_norm(), bc = (b.position - c.position).squared_norm(),
               ca = (c.position - a.position).squared_norm();
  if (std::max({ab, bc, ca}) < smallest_) return false;
  if (bc > ab && bc >= ca) return contains(b, c, a);
  if (ca > ab) return contains(c, a, b);
  Corner middle{(a.position + b.position) / 2, {}};
  middle.near = near(middle.position);
  return middle.near.size > 0 && contains(a, middle, c) && contains(middle, b, c);
}

}  // namespace multimesh::spatial
