// SPDX-License-Identifier: BSD-3-Clause
#include "test/tetgen/closed_shapes.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace multimesh::test {

using tetgen::Point;

namespace {

ClosedSurface made(std::vector<Point> points, std::vector<Index> corners) {
  const auto size = static_cast<Index>(points.size());
  return {std::move(points), FacetList{.dimension = 2, .vertices = size, .corners = std::move(corners)}};
}

}  // namespace

ClosedSurface cube(double s) {
  return made({{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0}, {0, 0, s}, {s, 0, s}, {s, s, s}, {0, s, s}},
              {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
               1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7});
}

ClosedSurface sphere(double radius, int levels, const Point& center) {
  std::vector<Point> points{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Index> corners{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<Index, Index>, Index> middles;
    const auto middle = [&](Index a, Index b) {
      const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), static_cast<Index>(points.size()));
      if (is_new) {
        Point p{};
        for (std::size_t i = 0; i < 3; ++i) p[i] = points[a][i] + points[b][i];
        const double length = std::hypot(p[0], p[1], p[2]);
        for (double& x : p) x /= length;
        points.push_back(p);
      }
      return at->second;
    };
    std::vector<Index> finer;
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      const Index a = corners[t], b = corners[t + 1], c = corners[t + 2];
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
    }
    corners = std::move(finer);
  }
  for (Point& p : points)
    for (std::size_t i = 0; i < 3; ++i) p[i] = center[i] + radius * p[i];
  return made(std::move(points), std::move(corners));
}

ClosedSurface torus(double radius, double thickness, Index around, Index across) {
  std::vector<Point> points;
  std::vector<Index> corners;
  for (Index i = 0; i < around; ++i)
    for (Index j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = radius + thickness * std::cos(v);
      points.push_back({r * std::cos(u), r * std::sin(u), thickness * std::sin(v)});
      const auto at = [&](Index k, Index l) { return k % around * across + l % across; };
      corners.insert(corners.end(),
                     {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return made(std::move(points), std::move(corners));
}

ClosedSurface reversed(ClosedSurface surface) {
  for (std::size_t t = 0; t < surface.triangles.corners.size(); t += 3)
    std::swap(surface.triangles.corners[t], surface.triangles.corners[t + 1]);
  return surface;
}

ClosedSurface joined(const ClosedSurface& a, const ClosedSurface& b) {
  ClosedSurface both = a;
  both.points.insert(both.points.end(), b.points.begin(), b.points.end());
  for (const Index v : b.triangles.corners)
    both.triangles.corners.push_back(v + static_cast<Index>(a.points.size()));
  both.triangles.vertices = static_cast<Index>(both.points.size());
  return both;
}

}  // namespace multimesh::test
