// SPDX-License-Identifier: BSD-3-Clause
// Shares no code with the program.
#include "test/improve/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace multimesh::test {

namespace {

Point minus(const Point& p, const Point& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
double product(const Point& p, const Point& q) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
Point normal(const Point& p, const Point& q) {
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const Point along = minus(b, a), to_p = minus(p, a);
  const double length = product(along, along);
  const double t = length > 0 ? std::clamp(product(along, to_p) / length, 0.0, 1.0) : 0;
  const Point rest{to_p[0] - t * along[0], to_p[1] - t * along[1], to_p[2] - t * along[2]};
  return std::sqrt(product(rest, rest));
}

}  // namespace

double distance(const Point& p, const PlainTriangle& t) {
  const Point n = normal(minus(t[1], t[0]), minus(t[2], t[0]));
  bool above = product(n, n) > 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Point &a = t[i], &b = t[(i + 1) % 3];
    least = std::min(least, distance_to_segment(p, a, b));
    above = above && product(normal(n, minus(b, a)), minus(p, a)) >= 0;
  }
  return above ? std::min(least, std::abs(product(n, minus(p, t[0]))) / std::sqrt(product(n, n))) : least;
}

double sampled_distance(const std::vector<PlainTriangle>& from, const std::vector<PlainTriangle>& to,
                        int per_edge) {
  double greatest = 0;
  for (const PlainTriangle& t : from)
    for (int i = 0; i <= per_edge; ++i)
      for (int j = 0; i + j <= per_edge; ++j) {
        const double u = 1.0 * i / per_edge, v = 1.0 * j / per_edge;
        Point p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = (1 - u - v) * t[0][k] + u * t[1][k] + v * t[2][k];
        double least = std::numeric_limits<double>::infinity();
        for (const PlainTriangle& other : to) least = std::min(least, distance(p, other));
        greatest = std::max(greatest, least);
      }
  return greatest;
}

}  // namespace multimesh::test
