// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/texture_map.hpp"

#include <cmath>
#include <optional>

#include "multimesh/geometry/bounding_box.hpp"

namespace multimesh::comparison {

using spatial::Nearby;
using spatial::PointOnTriangle;
using spatial::Triangle;
using spatial::TriangleTree;

namespace {

std::vector<Index> textured_triangles(const TexturedTriangles& surface) {
  std::vector<Index> textured;
  for (Index t = 0; t < surface.triangles.size(); ++t)
    if (is_textured(surface.triangles[t])) textured.push_back(t);
  return textured;
}

/// A tree over some triangles, as returned by `corners` (in_space or in_texture).
TriangleTree tree_over(const TexturedTriangles& surface, const std::vector<Index>& which,
                       Triangle (*corners)(const TexturedTriangles&, const Corners&)) {
  std::vector<Triangle> triangles;
  triangles.reserve(which.size());
  for (const Index t : which) triangles.push_back(corners(surface, surface.triangles[t]));
  return TriangleTree(std::move(triangles));
}

double bounding_diagonal(const std::vector<Triangle>& triangles) {
  std::vector<Vec3> points;
  points.reserve(3 * triangles.size());
  for (const Triangle& t : triangles)
    for (const auto& p : t) points.push_back(p);
  return bounding_box_diagonal(points);
}

}  // namespace

TextureMap::TextureMap(const TexturedTriangles& surface, Search search)
    : surface_(surface),
      textured_(textured_triangles(surface)),
      in_texture_(tree_over(surface, textured_, in_texture)) {
  diagonal_ = bounding_diagonal(in_texture_.triangles());
  if (search == Search::space || (search == Search::automatic && is_stacked()))
    in_space_ = tree_over(surface, textured_, in_space);
}

// Some models have thousands of triangles at one place of the texture, or all of them. Searching the texture
// would then visit all of these for each place. A sample of triangles detects this.
bool TextureMap::is_stacked() const {
  constexpr std::size_t asked = 32, many = 100;
  const std::size_t n = textured_.size(), step = std::max<std::size_t>(1, n / asked);
  std::size_t found = 0, times = 0;
  std::vector<Nearby> buffer;
  for (std::size_t i = step / 2; i < n; i += step, ++times) {
    in_texture_.within(spatial::at(in_texture_.triangles()[i], {1.0 / 3, 1.0 / 3, 1.0 / 3}), touching(),
                       buffer);
    found += buffer.size();
  }
  return found > many * times;
}

TextureMap::Place TextureMap::place(const Nearby& found, double uv_distance) const {
  const Index t = textured_[found.facet];
  return {spatial::at(in_space(surface_, surface_.triangles[t]), found.barycentric), t, uv_distance};
}

TextureMap::Place TextureMap::search_texture(const Vec3& uv, const Vec3& near,
                                             std::vector<Nearby>& buffer) const {
  const double outside = std::sqrt(in_texture_.nearest(uv)->squared_distance);
  in_texture_.within(uv, outside <= touching() ? touching() : outside + touching(), buffer);
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (const Nearby& candidate : buffer) {
    const Place found = place(candidate, outside);
    if (const double d = (found.position - near).squared_norm(); d < least) {
      least = d;
      best = found;
    }
  }
  return best;
}

TextureMap::Place TextureMap::operator()(const Vec2& uv, const Vec3& near,
                                         std::vector<Nearby>& buffer) const {
  const Vec3 p = in_space(uv);
  if (!in_space_) return search_texture(p, near, buffer);
  const double limit = touching() * touching();
  const auto choose = [&](Index facet) -> std::optional<PointOnTriangle> {
    const PointOnTriangle q = spatial::closest_point(p, in_texture_.triangles()[facet]);
    if (q.squared_distance > limit) return std::nullopt;
    const Vec3 x = spatial::at(in_space_->triangles()[facet], q.barycentric);
    return PointOnTriangle{q.barycentric, (x - near).squared_norm()};
  };
  if (const auto found = in_space_->nearest_chosen(near, choose)) return place(*found, 0);
  return search_texture(p, near, buffer);
}

std::optional<TextureMap::Place> TextureMap::within(const Vec2& uv, const std::vector<Index>& part,
                                                    Index which) const {
  const Vec3 p = in_space(uv);
  const auto choose = [&](Index facet) -> std::optional<PointOnTriangle> {
    if (part[textured_[facet]] != which) return std::nullopt;
    return spatial::closest_point(p, in_texture_.triangles()[facet]);
  };
  const auto found = in_texture_.nearest_chosen(p, choose);
  if (!found) return std::nullopt;
  return place(*found, std::sqrt(found->squared_distance));
}

}  // namespace multimesh::comparison
