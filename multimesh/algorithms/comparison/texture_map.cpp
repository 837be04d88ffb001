// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/texture_map.hpp"

#include <cmath>

#include "multimesh/algorithms/bounding_box.hpp"

namespace multimesh::comparison {

namespace {

std::vector<Index> textured_triangles(const TexturedTriangles& surface) {
  std::vector<Index> textured;
  for (Index t = 0; t < surface.triangles.size(); ++t)
    if (is_textured(surface.triangles[t])) textured.push_back(t);
  return textured;
}

std::vector<spatial::Triangle> all_in_texture(const TexturedTriangles& surface,
                                              const std::vector<Index>& triangles) {
  std::vector<spatial::Triangle> all;
  all.reserve(triangles.size());
  for (const Index t : triangles) all.push_back(in_texture(surface, surface.triangles[t]));
  return all;
}

double uv_diagonal(const std::vector<spatial::Triangle>& triangles) {
  std::vector<OpenMesh::Vec3d> points;
  points.reserve(3 * triangles.size());
  for (const auto& t : triangles)
    for (const auto& p : t) points.push_back(vec(p));
  return bounding_box_diagonal(points);
}

}  // namespace

TextureMap::TextureMap(const TexturedTriangles& surface)
    : surface_(surface), textured_(textured_triangles(surface)), tree_(all_in_texture(surface, textured_)) {
  diagonal_ = uv_diagonal(tree_.triangles());
}

TextureMap::Place TextureMap::operator()(const OpenMesh::Vec2d& uv, const OpenMesh::Vec3d& near,
                                         std::vector<spatial::Nearby>& buffer) const {
  const spatial::Point p = to_point(uv);
  const double outside = std::sqrt(tree_.nearest(p)->squared_distance);
  tree_.within(p, outside + touching(), buffer);
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (const spatial::Nearby& candidate : buffer) {
    const Index t = textured_[candidate.facet];
    const OpenMesh::Vec3d x =
        vec(spatial::at(in_space(surface_, surface_.triangles[t]), candidate.barycentric));
    if (const double d = (x - near).sqrnorm(); d < least) {
      least = d;
      best = {x, t, outside};
    }
  }
  return best;
}

}  // namespace multimesh::comparison
