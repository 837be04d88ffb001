// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/texture_comparison.hpp"

#include <cmath>

#include "multimesh/algorithms/comparison/parallel.hpp"

namespace multimesh::comparison {

std::vector<TextureMap::Place> painted(const TextureMap& map, const std::vector<TexturedPoint>& points,
                                       unsigned threads) {
  std::vector<TextureMap::Place> places(points.size());
  for_each_block(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::vector<spatial::Nearby> buffer;
    for (std::size_t i = begin; i < end; ++i) places[i] = map(points[i].uv, points[i].position, buffer);
  });
  return places;
}

SeamPoints sample_seams(const std::vector<SeamEdge>& seams, std::size_t count) {
  double total = 0;
  for (const SeamEdge& s : seams) total += (s.position[1] - s.position[0]).norm();
  SeamPoints points;
  if (!(total > 0)) return points;
  const double step = total / static_cast<double>(count);
  double next = step / 2;  // from the beginning of the edge
  for (const SeamEdge& s : seams) {
    const double length = (s.position[1] - s.position[0]).norm();
    for (; next < length; next += step) {
      const double t = next / length;
      const OpenMesh::Vec3d p = s.position[0] * (1 - t) + s.position[1] * t;
      points.left.push_back({p, s.left[0] * (1 - t) + s.left[1] * t});
      points.right.push_back({p, s.right[0] * (1 - t) + s.right[1] * t});
    }
    next -= length;
  }
  return points;
}

std::vector<double> orientation_by_original(const std::vector<double>& orientation,
                                            const TexturedTriangles& other, const std::vector<Index>& chart,
                                            const TextureMap& map, unsigned threads) {
  const std::vector<double> area = uv_areas(other);
  std::vector<TexturedPoint> centroids;
  std::vector<Index> textured;
  for (Index t = 0; t < other.triangles.size(); ++t) {
    const Corners& c = other.triangles[t];
    if (!is_textured(c)) continue;
    textured.push_back(t);
    centroids.push_back({(position(other, c[0]) + position(other, c[1]) + position(other, c[2])) / 3,
                         (texcoord(other, c[0]) + texcoord(other, c[1]) + texcoord(other, c[2])) / 3});
  }
  const auto places = painted(map, centroids, threads);
  std::vector<double> vote(area.size(), 0.0);
  for (std::size_t i = 0; i < textured.size(); ++i)
    vote[textured[i]] = std::copysign(area[textured[i]], orientation[places[i].triangle]);
  return sum_over_charts(chart, vote);
}

}  // namespace multimesh::comparison
