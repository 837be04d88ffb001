// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "multimesh/algorithms/comparison/charts.hpp"
#include "multimesh/algorithms/comparison/samples.hpp"
#include "multimesh/algorithms/comparison/texture_map.hpp"

namespace multimesh::comparison {

/// A textured point of the other surface.
struct TexturedPoint {
  OpenMesh::Vec3d position;
  OpenMesh::Vec2d uv;
};

/// Per point the place of the original that is painted there.
std::vector<TextureMap::Place> painted(const TextureMap& map, const std::vector<TexturedPoint>& points,
                                       unsigned threads);

/// `count` points in equal distances along the seams, on the left and on the right side.
struct SeamPoints {
  std::vector<TexturedPoint> left, right;
};
SeamPoints sample_seams(const std::vector<SeamEdge>& seams, std::size_t count);

/// Per triangle of the other surface a number with the sign that its chart's area should have: the original's
/// `orientation`, likewise per triangle, at the centroids of the chart's triangles, weighted by their area.
std::vector<double> orientation_by_original(const std::vector<double>& orientation,
                                            const TexturedTriangles& other, const std::vector<Index>& chart,
                                            const TextureMap& map, unsigned threads);

}  // namespace multimesh::comparison
