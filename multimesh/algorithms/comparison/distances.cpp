// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/distances.hpp"

#include <cmath>

#include "multimesh/algorithms/comparison/parallel.hpp"

namespace multimesh::comparison {

spatial::TriangleTree tree_in_space(const TexturedTriangles& surface) {
  std::vector<spatial::Triangle> triangles;
  triangles.reserve(surface.triangles.size());
  for (const Corners& t : surface.triangles) triangles.push_back(in_space(surface, t));
  return spatial::TriangleTree(std::move(triangles));
}

std::vector<Vec3> points(const TexturedTriangles& surface, const std::vector<Sample>& samples) {
  std::vector<Vec3> all;
  all.reserve(samples.size());
  for (const Sample& s : samples)
    all.push_back(spatial::at(in_space(surface, surface.triangles[s.triangle]), s.barycentric));
  return all;
}

std::vector<spatial::Nearby> closest(const spatial::TriangleTree& surface, const std::vector<Vec3>& points,
                                     unsigned threads) {
  std::vector<spatial::Nearby> all(points.size());
  for_each_block(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    Index last = 0;
    for (std::size_t i = begin; i < end; ++i) {
      // The closest triangle of the previous point bounds the search, with room for rounding.
      const Vec3& p = points[i];
      const double bound = std::sqrt(spatial::closest_point(p, surface.triangles()[last]).squared_distance);
      all[i] = *surface.nearest(p, bound * (1 + 1e-12) + std::numeric_limits<double>::min());
      last = all[i].facet;
    }
  });
  return all;
}

std::vector<Index> used_positions(const TexturedTriangles& surface) {
  std::vector<bool> used(surface.positions.size(), false);
  for (const Corners& t : surface.triangles)
    for (const auto& c : t) used[static_cast<std::size_t>(c.position)] = true;
  std::vector<Index> all;
  for (Index i = 0; i < used.size(); ++i)
    if (used[i]) all.push_back(i);
  return all;
}

}  // namespace multimesh::comparison
