// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/surface_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>

#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

std::string name(const char* what, std::size_t number) {
  return std::string(what) + " " + std::to_string(number);
}

std::string edge_name(Index a, Index b) {
  return "the edge between points " + std::to_string(a) + " and " + std::to_string(b);
}

/// Whether the corners are on one line, up to the roundings of this test. What passes is left to TetGen.
bool has_area(const Point& a, const Point& b, const Point& c) {
  using Vector = std::array<long double, 3>;
  const auto minus = [](const Point& p, const Point& q) {
    return Vector{static_cast<long double>(p[0]) - q[0], static_cast<long double>(p[1]) - q[1],
                  static_cast<long double>(p[2]) - q[2]};
  };
  const Vector u = minus(b, a), v = minus(c, a);
  const auto length = [](const Vector& w) { return std::hypot(w[0], w[1], w[2]); };
  const Vector n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  return length(n) > 4 * std::numeric_limits<long double>::epsilon() * length(u) * length(v);
}

void check_corners(std::span<const Point> points, const FacetList& triangles) {
  if (triangles.dimension != 2 || triangles.corners.size() % 3 != 0)
    throw UsageError("tetrahedralize: the surface is not a list of triangles");
  if (triangles.size() < 4)
    throw InputError("a closed surface has at least 4 triangles, this one has " +
                     std::to_string(triangles.size()));
  constexpr std::size_t most = 100'000'000;  // TetGen counts with int
  if (points.size() > most || triangles.size() > most)
    throw InputError("the surface is too large: at most " + std::to_string(most) + " triangles and points");
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto c = triangles.facet(t);
    for (const Index v : c)
      if (v >= points.size()) throw InputError(name("triangle", t) + ": there is no " + name("point", v));
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      throw InputError(name("triangle", t) + " is degenerate: it repeats a point");
    for (const Index v : c)
      if (!std::all_of(points[v].begin(), points[v].end(), [](double x) { return std::isfinite(x); }))
        throw InputError(name("point", v) + ": a coordinate is not finite");
  }
}

void check_size(std::span<const Point> points, const FacetList& triangles) {
  Point low = points[triangles.corners[0]], high = low;
  for (const Index v : triangles.corners)
    for (std::size_t i = 0; i < 3; ++i)
      low[i] = std::min(low[i], points[v][i]), high[i] = std::max(high[i], points[v][i]);
  const double size = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
  if (size > 0 && !(size >= 1e-40 && size <= 1e40))
    throw InputError("the surface extends over " + std::to_string(size) + ": scale it to about 1");
  for (std::size_t i = 0; i < 3; ++i)
    if (low[i] == high[i])
      throw InputError("the surface is flat: it has no extent along axis " + std::to_string(i));
}

void check_points_differ(std::span<const Point> points, const FacetList& triangles) {
  std::vector<Index> used = triangles.corners;
  const auto less = [&](Index a, Index b) { return std::tie(points[a], a) < std::tie(points[b], b); };
  std::sort(used.begin(), used.end(), less);
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto same =
      std::adjacent_find(used.begin(), used.end(), [&](Index a, Index b) { return points[a] == points[b]; });
  if (same != used.end())
    throw InputError("points " + std::to_string(same[0]) + " and " + std::to_string(same[1]) +
                     " are at the same place: merge them");
}

void check_triangles_differ(const FacetList& triangles) {
  std::vector<std::pair<std::array<Index, 3>, Index>> keys(triangles.size());
  for (Index t = 0; t < keys.size(); ++t) {
    const auto c = triangles.facet(t);
    keys[t] = {{c[0], c[1], c[2]}, t};
    std::sort(keys[t].first.begin(), keys[t].first.end());
  }
  std::sort(keys.begin(), keys.end());
  const auto same = std::adjacent_find(keys.begin(), keys.end(),
                                       [](const auto& a, const auto& b) { return a.first == b.first; });
  if (same != keys.end())
    throw InputError("triangles " + std::to_string(same[0].second) + " and " +
                     std::to_string(same[1].second) + " have the same corners");
}

void check_edges(const FacetList& triangles) {
  struct Side {
    Index low, high, triangle;
    bool forward;
  };
  std::vector<Side> sides;
  sides.reserve(triangles.corners.size());
  for (Index t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangles.facet(t)[k], b = triangles.facet(t)[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t, a < b});
    }
  const auto key = [](const Side& s) { return std::tie(s.low, s.high, s.triangle); };
  std::sort(sides.begin(), sides.end(), [&](const Side& a, const Side& b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t end = i;
    while (end < sides.size() && sides[end].low == sides[i].low && sides[end].high == sides[i].high) ++end;
    const std::string edge =
        edge_name(sides[i].low, sides[i].high) + ", of " + name("triangle", sides[i].triangle);
    if (end - i == 1) throw InputError("the surface is open: " + edge + ", has no other triangle");
    if (end - i > 2)
      throw InputError("the surface is not manifold: " + edge + ", has " + std::to_string(end - i) +
                       " triangles");
    if (sides[i].forward == sides[i + 1].forward)
      throw InputError("the orientation is not consistent: " + edge + ", has the same direction in " +
                       name("triangle", sides[i + 1].triangle));
    i = end;
  }
}

}  // namespace

void check_closed_surface(std::span<const Point> points, const FacetList& triangles) {
  check_corners(points, triangles);
  check_triangles_differ(triangles);
  check_edges(triangles);
  check_points_differ(points, triangles);
  check_size(points, triangles);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto c = triangles.facet(t);
    if (!has_area(points[c[0]], points[c[1]], points[c[2]]))
      throw InputError(name("triangle", t) + " is degenerate: its corners are on a line");
  }
}

}  // namespace multimesh::tetgen
