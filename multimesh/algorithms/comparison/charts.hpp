// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/comparison/edge_sides.hpp"

namespace multimesh::comparison {

/// Per triangle the least triangle of its chart. Triangles are in one chart if they, and no third one, meet
/// in an edge of the texture, and agree in orientation there. A triangle without texture is a chart alone.
std::vector<Index> charts(const TexturedTriangles& surface, const EdgeSides& sides);

/// Per triangle the sum of `weight` over its chart.
std::vector<double> sum_over_charts(const std::vector<Index>& chart, const std::vector<double>& weight);

/// Signed area in the UV plane per triangle; 0 without texture.
std::vector<double> uv_areas(const TexturedTriangles& surface);

struct Flips {
  std::size_t flipped = 0;    ///< triangles whose area does not have the sign of their `orientation`
  std::size_t zero_area = 0;  ///< triangles whose area is at most `tolerance`; not counted as flipped
};

/// For the textured triangles; `orientation` per triangle of the surface.
Flips count_flips(const TexturedTriangles& surface, const std::vector<double>& orientation, double tolerance);

}  // namespace multimesh::comparison
