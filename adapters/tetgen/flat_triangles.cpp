// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/flat_triangles.hpp"

#include <algorithm>
#include <cmath>

#include "adapters/tetgen/surface_measure.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh::tetgen {

namespace {

/// Sorts points of a line by the coordinate in which they differ most.
void sort_along(std::span<const Point> points, std::vector<Index>& line) {
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] = std::minmax_element(
        line.begin(), line.end(), [&](Index a, Index b) { return points[a][i] < points[b][i]; });
    if (const double extent = points[*high][i] - points[*low][i]; extent > most) axis = i, most = extent;
  }
  std::sort(line.begin(), line.end(), [&](Index a, Index b) {
    return points[a][axis] != points[b][axis] ? points[a][axis] < points[b][axis] : a < b;
  });
}

}  // namespace

FlatTriangles::FlatTriangles(std::span<const Point> points, std::span<const std::array<Index, 3>> triangles,
                             const std::vector<bool>& used, double least_height)
    : points_(points), least_height_(least_height) {
  UnionFind joined(triangles.size());
  std::map<std::array<Index, 2>, Index> at_edge;
  for (Index t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(triangles[t][k], triangles[t][(k + 1) % 3]);
      joined.join(at_edge.try_emplace({low, high}, t).first->second, t);
    }
  std::map<Index, std::vector<Index>> points_of;
  for (Index t = 0; t < triangles.size(); ++t)
    for (const Index v : triangles[t])
      if (used[v]) points_of[joined.find(t)].push_back(v);
  for (auto& [part, line] : points_of) {
    std::sort(line.begin(), line.end());
    line.erase(std::unique(line.begin(), line.end()), line.end());
    sort_along(points, line);
    for (const Index v : line) lines_at_[v].push_back(static_cast<Index>(lines_.size()));
    lines_.push_back(std::move(line));
  }
}

std::vector<Index> FlatTriangles::points_on(Index a, Index b, Index third) const {
  const auto at_a = lines_at_.find(a);
  if (at_a == lines_at_.end()) return {};
  for (const Index l : at_a->second) {
    const auto& line = lines_[l];
    const auto place = [&](Index v) { return std::find(line.begin(), line.end(), v); };
    auto i = place(a), j = place(b);
    if (j == line.end() || place(third) != line.end()) continue;
    const bool forward = i < j;
    if (!forward) std::swap(i, j);
    std::vector<Index> between(i + 1, j);
    std::erase_if(between, [&](Index x) { return has_area(points_, {a, x, b}, least_height_); });
    if (!forward) std::reverse(between.begin(), between.end());
    return between;
  }
  return {};
}

}  // namespace multimesh::tetgen
