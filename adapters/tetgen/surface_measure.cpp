// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/surface_measure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multimesh::tetgen {

namespace {

LongVector minus(const Point& p, const Point& q) {
  return {static_cast<long double>(p[0]) - q[0], static_cast<long double>(p[1]) - q[1],
          static_cast<long double>(p[2]) - q[2]};
}

LongVector cross(const LongVector& u, const LongVector& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

long double length(const LongVector& v) {
  return std::sqrt(dot(v, v));
}

}  // namespace

long double dot(const LongVector& a, const LongVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

LongVector area_vector(std::span<const Point> points, const std::array<Index, 3>& c) {
  return cross(minus(points[c[1]], points[c[0]]), minus(points[c[2]], points[c[0]]));
}

long double volume_of(std::span<const Point> points, const std::array<Index, 4>& c) {
  return dot(area_vector(points, {c[0], c[1], c[2]}), minus(points[c[3]], points[c[0]])) / 6;
}

long double least_volume(std::span<const Point> points, const std::array<Index, 4>& c) {
  long double product = 1;
  for (std::size_t k = 1; k < 4; ++k) product *= length(minus(points[c[k]], points[c[0]]));
  return 16 * std::numeric_limits<long double>::epsilon() * product;
}

bool has_area(std::span<const Point> points, const std::array<Index, 3>& c, long double least_height) {
  const LongVector u = minus(points[c[1]], points[c[0]]), v = minus(points[c[2]], points[c[0]]);
  const long double area = length(cross(u, v)),
                    longest = std::max({length(u), length(v), length(minus(points[c[2]], points[c[1]]))});
  return area > 4 * std::numeric_limits<long double>::epsilon() * length(u) * length(v) &&
         area > least_height * longest;
}

long double cone_volume(std::span<const Point> points, const std::array<Index, 3>& c, const Point& origin) {
  return dot(cross(minus(points[c[0]], origin), minus(points[c[1]], origin)), minus(points[c[2]], origin)) /
         6;
}

long double diagonal(std::span<const Point> points) {
  Point low = points[0], high = low;
  for (const Point& p : points)
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  return length(minus(high, low));
}

bool is_covered(std::span<const Point> points, const std::array<Index, 3>& triangle,
                std::span<const std::array<Index, 3>> parts, long double diagonal) {
  const LongVector area = area_vector(points, triangle);
  LongVector rest = area;
  for (const auto& part : parts) {
    const LongVector covered = area_vector(points, part);
    for (std::size_t i = 0; i < 3; ++i) rest[i] -= covered[i];
  }
  // Points that split a triangle are on it up to the precision of coordinates: for needles, that is much.
  long double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, length(minus(points[triangle[k]], points[triangle[(k + 1) % 3]])));
  return length(rest) <= 1e-9L * length(area) + 1e-13L * longest * diagonal;
}

}  // namespace multimesh::tetgen
