// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/texture_comparison.hpp"

#include <atomic>
#include <cmath>
#include <map>

#include "multimesh/algorithms/comparison/parallel.hpp"

namespace multimesh::comparison {

std::vector<TexturedPoint> textured_points(const TexturedTriangles& surface,
                                           const std::vector<Sample>& samples) {
  std::vector<TexturedPoint> points;
  for (const Sample& s : samples) {
    const Corners& t = surface.triangles[s.triangle];
    if (!is_textured(t)) continue;
    const Vec3 uv = spatial::at(in_texture(surface, t), s.barycentric);
    points.push_back({spatial::at(in_space(surface, t), s.barycentric), {uv[0], uv[1]}, s.triangle});
  }
  return points;
}

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
      const Vec3 p = s.position[0] * (1 - t) + s.position[1] * t;
      points.left.push_back({p, s.left[0] * (1 - t) + s.left[1] * t, s.triangle[0]});
      points.right.push_back({p, s.right[0] * (1 - t) + s.right[1] * t, s.triangle[1]});
    }
    next -= length;
  }
  return points;
}

PaintedCentroids painted_centroids(const TexturedTriangles& other, const TextureMap& map, unsigned threads) {
  PaintedCentroids all;
  for (Index t = 0; t < other.triangles.size(); ++t) {
    const Corners& c = other.triangles[t];
    if (!is_textured(c)) continue;
    all.points.push_back({(position(other, c[0]) + position(other, c[1]) + position(other, c[2])) / 3,
                          (texcoord(other, c[0]) + texcoord(other, c[1]) + texcoord(other, c[2])) / 3, t});
  }
  all.places = painted(map, all.points, threads);
  return all;
}

ChartPairs::ChartPairs(const std::vector<Index>& original, const TexturedTriangles& other,
                       const std::vector<Index>& other_chart, const PaintedCentroids& centroids,
                       double diagonal)
    : original_(original), own_(other.triangles.size(), no_index) {
  constexpr double close = 0.01;  // relative to the diagonal: within it, all places count about the same
  const std::vector<double> area = uv_areas(other);
  std::map<std::array<Index, 2>, double> votes;
  for (std::size_t i = 0; i < centroids.points.size(); ++i) {
    const TexturedPoint& point = centroids.points[i];
    const TextureMap::Place& place = centroids.places[i];
    const double deviation = (place.position - point.position).norm() / diagonal;
    votes[{other_chart[point.triangle], original[place.triangle]}] +=
        std::abs(area[point.triangle]) / (close + deviation);
  }
  std::vector<double> most(other.triangles.size(), 0);
  for (const auto& [charts, vote] : votes)
    if (vote > most[charts[0]]) {
      most[charts[0]] = vote;
      own_[charts[0]] = charts[1];
    }
  for (std::size_t t = 0; t < own_.size(); ++t) own_[t] = own_[other_chart[t]];
}

std::size_t ChartPairs::move_into_charts(const TextureMap& map, const std::vector<TexturedPoint>& points,
                                         std::vector<TextureMap::Place>& places, unsigned threads) const {
  std::atomic<std::size_t> outside = 0;
  for_each_block(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const TexturedPoint& p = points[i];
      const Index own = own_[p.triangle];
      const bool elsewhere = own != no_index && original_[places[i].triangle] != own;
      const TextureMap::Place place = elsewhere ? *map.within(p.uv, original_, own) : places[i];
      outside += place.uv_distance > map.rounding();
      if ((place.position - p.position).squared_norm() < (places[i].position - p.position).squared_norm())
        places[i] = place;
    }
  });
  return outside;
}

std::vector<double> orientation_by_original(const std::vector<double>& orientation,
                                            const TexturedTriangles& other, const std::vector<Index>& chart,
                                            const PaintedCentroids& centroids) {
  const std::vector<double> area = uv_areas(other);
  std::vector<double> vote(area.size(), 0.0);
  for (std::size_t i = 0; i < centroids.points.size(); ++i) {
    const Index t = centroids.points[i].triangle;
    vote[t] = std::copysign(area[t], orientation[centroids.places[i].triangle]);
  }
  return sum_over_charts(chart, vote);
}

}  // namespace multimesh::comparison
