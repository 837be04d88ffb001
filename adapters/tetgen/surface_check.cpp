// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/surface_check.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>

#include "multimesh/error.hpp"

namespace multimesh::tetgen {

namespace {

std::string name(const char* what, std::size_t number) {
  return std::string(what) + " " + std::to_string(number);
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

}  // namespace

void check_points(std::span<const Point> points, const FacetList& triangles) {
  check_corners(points, triangles);
  check_points_differ(points, triangles);
  check_size(points, triangles);
}

std::string first_open_edge(const Facets& facets) {
  std::vector<std::pair<std::array<Index, 2>, Index>> sides;
  for (Index f = 0; f < facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({facets.facet(f)[k], facets.facet(f)[(k + 1) % 3]});
      sides.push_back({{low, high}, f});
    }
  std::sort(sides.begin(), sides.end());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const auto& edge = sides[i].first;
    const bool is_shared =
        (i > 0 && sides[i - 1].first == edge) || (i + 1 < sides.size() && sides[i + 1].first == edge);
    if (!is_shared)
      return "the edge between points " + std::to_string(edge[0]) + " and " + std::to_string(edge[1]) +
             ", of " + name("triangle", facets.sources_of(sides[i].second)[0].triangle) +
             ", has no other triangle";
  }
  return {};
}

}  // namespace multimesh::tetgen
