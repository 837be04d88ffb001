// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "multimesh/algorithms/comparison/charts.hpp"
#include "multimesh/algorithms/comparison/samples.hpp"
#include "multimesh/algorithms/comparison/texture_map.hpp"

namespace multimesh::comparison {

/// A textured point of the other surface.
struct TexturedPoint {
  Vec3 position;
  Vec2 uv;
  Index triangle = no_index;  ///< to which the point belongs
};

/// The samples that lie on textured triangles.
std::vector<TexturedPoint> textured_points(const TexturedTriangles& surface,
                                           const std::vector<Sample>& samples);

/// Per point the place of the original whose content is drawn there.
std::vector<TextureMap::Place> painted(const TextureMap& map, const std::vector<TexturedPoint>& points,
                                       unsigned threads);

/// The centroids of the textured triangles of the other surface, and what is drawn there.
struct PaintedCentroids {
  std::vector<TexturedPoint> points;
  std::vector<TextureMap::Place> places;
};
PaintedCentroids painted_centroids(const TexturedTriangles& other, const TextureMap& map, unsigned threads);

/// The charts of the original to which those of the other surface correspond.
class ChartPairs {
 public:
  /// `original`, `other`: their charts, per triangle. A chart is paired with the original's chart that is
  /// drawn on most of it. Places drawn close to where they belong count more, because a strip along the edge
  /// may lie in a neighbour of the atlas.
  ChartPairs(const std::vector<Index>& original, const TexturedTriangles& other,
             const std::vector<Index>& other_chart, const PaintedCentroids& centroids, double diagonal);

  /// Moves the places drawn at points into the charts of the points: where a place is in another chart of the
  /// original, and the nearest place of the point's own chart is nearer to the point, takes the latter.
  /// \return how many points lie outside their own chart by more than TextureMap::rounding()
  std::size_t move_into_charts(const TextureMap& map, const std::vector<TexturedPoint>& points,
                               std::vector<TextureMap::Place>& places, unsigned threads) const;

 private:
  const std::vector<Index>& original_;
  std::vector<Index> own_;  // per triangle of the other surface
};

/// `count` equidistant points along the seams, on the left and on the right side.
struct SeamPoints {
  std::vector<TexturedPoint> left, right;
};
SeamPoints sample_seams(const std::vector<SeamEdge>& seams, std::size_t count);

/// Per triangle of the other surface a number with the sign that its chart's area should have: the original's
/// `orientation`, likewise per triangle, at the centroids of the chart's triangles, weighted by their area.
std::vector<double> orientation_by_original(const std::vector<double>& orientation,
                                            const TexturedTriangles& other, const std::vector<Index>& chart,
                                            const PaintedCentroids& centroids);

}  // namespace multimesh::comparison
