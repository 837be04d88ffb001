// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/charts.hpp"

#include <cmath>

#include "multimesh/union_find.hpp"

namespace multimesh::comparison {

std::vector<Index> charts(const TexturedTriangles& surface, const EdgeSides& sides) {
  UnionFind sets(surface.triangles.size());
  sides.for_each_edge([&](std::span<const EdgeSide> at) {
    for (const EdgeSide& side : at) {
      const auto same = [&](const EdgeSide& s) { return sides.same_texture(side, s); };
      if (std::count_if(at.begin(), at.end(), same) != 2) continue;
      const EdgeSide& first = *std::find_if(at.begin(), at.end(), same);
      if (first.forward != side.forward) sets.join(side.triangle, first.triangle);
    }
  });
  std::vector<Index> chart(surface.triangles.size());
  for (Index t = 0; t < chart.size(); ++t) chart[t] = sets.find(t);
  return chart;
}

std::vector<double> sum_over_charts(const std::vector<Index>& chart, const std::vector<double>& weight) {
  std::vector<double> sum(chart.size(), 0.0);
  for (std::size_t t = 0; t < chart.size(); ++t) sum[chart[t]] += weight[t];
  for (std::size_t t = 0; t < chart.size(); ++t) sum[t] = sum[chart[t]];
  return sum;
}

std::vector<double> uv_areas(const TexturedTriangles& surface) {
  std::vector<double> areas(surface.triangles.size(), 0.0);
  for (std::size_t t = 0; t < areas.size(); ++t)
    if (is_textured(surface.triangles[t])) areas[t] = signed_area(in_texture(surface, surface.triangles[t]));
  return areas;
}

Flips count_flips(const TexturedTriangles& surface, const std::vector<double>& orientation,
                  double tolerance) {
  const std::vector<double> areas = uv_areas(surface);
  Flips flips;
  for (std::size_t t = 0; t < areas.size(); ++t) {
    if (!is_textured(surface.triangles[t])) continue;
    const bool zero = std::abs(areas[t]) <= tolerance;
    flips.zero_area += zero;
    flips.flipped += !zero && (areas[t] > 0) != (orientation[t] > 0);
  }
  return flips;
}

}  // namespace multimesh::comparison
