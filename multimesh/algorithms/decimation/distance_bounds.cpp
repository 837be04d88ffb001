// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/distance_bounds.hpp"

#include <limits>

#include "multimesh/closest_point.hpp"

namespace multimesh::decimation {

using OpenMesh::Vec2d;
using OpenMesh::Vec3d;

namespace {

spatial::Point point(const Vec3d& p) {
  return {p[0], p[1], p[2]};
}
spatial::Point point(const Vec2d& p) {
  return {p[0], p[1], 0};
}
template <class V>
spatial::Triangle triangle(const std::array<V, 3>& t) {
  return {point(t[0]), point(t[1]), point(t[2])};
}

}  // namespace

void PointBound::add_point(Index triangle) {
  next_.push_back(first_[triangle]);
  first_[triangle] = static_cast<Index>(next_.size() - 1);
}

bool PointBound::allows(const PredictedStar& star, const CollapsePlan&) {
  moves_.clear();
  for (const PredictedStar::Face& f : star.faces()) {
    if (!f.changes) continue;
    for (Index p = first_[f.before.facet]; p != no_index; p = next_[p]) {
      Nearness best{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
      Index triangle = no_index;
      for (const PredictedStar::Face& g : star.faces()) {
        if (g.dies) continue;
        const Nearness n = nearness(p, g);
        if (n.order < best.order) best = n, triangle = g.before.facet;
      }
      if (triangle == no_index || !within_bound(best.distance)) return false;
      moves_.push_back({p, triangle});
    }
  }
  return true;
}

void PointBound::collapsed(const PredictedStar& star, const CollapsePlan&) {
  for (const PredictedStar::Face& f : star.faces())
    if (f.changes) first_[f.before.facet] = no_index;
  for (const Move& m : moves_) {
    next_[m.point] = first_[m.triangle];
    first_[m.triangle] = m.point;
  }
}

VertexDistance::VertexDistance(const TexturedSurface& surface, double bound)
    : PointBound("maximal error", surface.tree().mesh(NodeId::root).capacity(2)), squared_bound_(bound * bound) {
  const Mesh& root = surface.tree().mesh(NodeId::root);
  for (Index v = 0; v < root.capacity(0); ++v) {
    if (!root.is_live(0, v)) continue;
    const Dart d = root.dart_of(0, v);
    if (d == no_dart) continue;
    points_.push_back(surface.positions()[v]);
    add_point(root.facet(d));
  }
}

PointBound::Nearness VertexDistance::nearness(Index p, const PredictedStar::Face& after) const {
  const double d = spatial::closest_point(point(points_[p]), triangle(after.positions_after())).squared_distance;
  return {d, d};
}

TextureDistance::TextureDistance(const TexturedSurface& surface, const TriangleReader& reader, std::size_t set,
                                 double bound)
    : PointBound(set == 0 ? "maximal texture error" : "maximal texture error " + std::to_string(set + 1),
                 surface.tree().mesh(NodeId::root).capacity(2)),
      set_(set),
      squared_bound_(bound * bound) {
  const Mesh& root = surface.tree().mesh(NodeId::root);
  std::vector<bool> seen(surface.tree().mesh(surface.textures()[set]).capacity(0), false);
  SurfaceTriangle t;
  for (Index f = 0; f < root.capacity(2); ++f) {
    if (!root.is_live(2, f)) continue;
    reader.read(root.dart_of(2, f), t);
    if (t.sets[set].facet == no_index) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index w = t.sets[set].vertices[i];
      if (seen[w]) continue;
      seen[w] = true;
      points_.push_back({t.positions[i], t.sets[set].texcoords[i]});
      add_point(f);
    }
  }
}

PointBound::Nearness TextureDistance::nearness(Index p, const PredictedStar::Face& after) const {
  if (after.before.sets[set_].facet == no_index) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {infinity, infinity};
  }
  const auto in_texture =
      spatial::closest_point(point(points_[p].texcoord), triangle(after.texcoords_after(set_)));
  const spatial::Point place = spatial::at(triangle(after.positions_after()), in_texture.barycentric);
  return {in_texture.squared_distance, (Vec3d(place[0], place[1], place[2]) - points_[p].position).sqrnorm()};
}

}  // namespace multimesh::decimation
