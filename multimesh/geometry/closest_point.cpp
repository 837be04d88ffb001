// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/geometry/closest_point.hpp"

#include <algorithm>

namespace multimesh::spatial {

namespace {

/// Keeps the better of `best` and the point with weights w of a triangle that was moved by -p.
void improve(PointOnTriangle& best, const Triangle& moved, const std::array<double, 3>& w) {
  const Vec3 q = at(moved, w);
  if (const double d = dot(q, q); d < best.squared_distance) best = {w, d};
}

void improve_by_edge(PointOnTriangle& best, const Triangle& moved, std::size_t i, const Vec3& edge) {
  const double length = dot(edge, edge);
  const double t = length > 0 ? std::clamp(-dot(moved[i], edge) / length, 0.0, 1.0) : 0.0;
  std::array<double, 3> w{};
  w[i] = 1 - t;
  w[(i + 1) % 3] = t;
  improve(best, moved, w);
}

}  // namespace

// With p as the origin, no digits are lost if the mesh is far from its own origin. A projection into the
// triangle by signed areas is exact enough if the triangle is not a needle. Otherwise its edges are tried as
// well, and the better point counts: any weights give a point of the triangle.
PointOnTriangle closest_point(const Vec3& p, const Triangle& triangle) {
  const Triangle moved{triangle[0] - p, triangle[1] - p, triangle[2] - p};
  const std::array<Vec3, 3> edge{triangle[1] - triangle[0], triangle[2] - triangle[1],
                                 triangle[0] - triangle[2]};
  PointOnTriangle best{{1, 0, 0}, dot(moved[0], moved[0])};
  const Vec3 normal = cross(edge[0], edge[1]);
  const double area = dot(normal, normal);
  if (area > 0) {
    // Twice the areas of the parts opposite to the corners, times |normal|.
    const double a = dot(normal, cross(moved[1], edge[1]));
    const double b = dot(normal, cross(moved[2], edge[2]));
    const double c = dot(normal, cross(moved[0], edge[0]));
    if (a >= 0 && b >= 0 && c >= 0 && a + b + c > 0) {
      const double sum = a + b + c;
      improve(best, moved, {a / sum, b / sum, c / sum});
      constexpr double needle = 1e-8;  // squared sine of an angle
      const double longest = std::max({dot(edge[0], edge[0]), dot(edge[1], edge[1]), dot(edge[2], edge[2])});
      if (area > needle * longest * longest) return best;
    }
  }
  for (std::size_t i = 0; i < 3; ++i) improve_by_edge(best, moved, i, edge[i]);
  return best;
}

}  // namespace multimesh::spatial
