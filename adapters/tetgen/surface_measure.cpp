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

long double enclosed_volume(std::span<const Point> points, std::span<const Index> corners) {
  // Seen from a point of the surface; from far away, the terms would be large and cancel.
  const Point& origin = points[corners[0]];
  long double sum = 0;
  for (std::size_t i = 0; i < corners.size(); i += 3)
    sum += dot(cross(minus(points[corners[i]], origin), minus(points[corners[i + 1]], origin)),
               minus(points[corners[i + 2]], origin));
  return sum / 6;
}

Index first_uncovered(std::span<const Point> points, std::span<const Index> corners,
                      std::span<const SurfaceFace> faces) {
  Point low = points[0], high = low;
  for (const Point& p : points)
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  const long double diagonal = length(minus(high, low));

  auto face = faces.begin();
  for (Index t = 0; t < corners.size() / 3; ++t) {
    const std::array<Index, 3> own{corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
    const LongVector area = area_vector(points, own);
    LongVector rest = area;
    for (; face != faces.end() && face->triangle == t; ++face) {
      const LongVector part = area_vector(points, face->corners);
      for (std::size_t i = 0; i < 3; ++i) rest[i] -= part[i];
    }
    // Points that split a triangle are on it up to the precision of coordinates: for needles, that is much.
    long double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, length(minus(points[own[k]], points[own[(k + 1) % 3]])));
    if (!(length(rest) <= 1e-9L * length(area) + 1e-13L * longest * diagonal)) return t;
  }
  return no_index;
}

}  // namespace multimesh::tetgen
