// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/texture_distance.hpp"

#include <limits>

#include "multimesh/geometry/closest_point.hpp"

namespace multimesh::decimation {

namespace {

spatial::Triangle in_space(const std::array<Vec2, 3>& t) {
  return {multimesh::in_space(t[0]), multimesh::in_space(t[1]), multimesh::in_space(t[2])};
}

}  // namespace

TextureDistance::TextureDistance(const TriangleReader& reader, std::size_t set, double bound)
    : PlacementTest(set == 0 ? "maximal texture error" : "maximal texture error " + std::to_string(set + 1)),
      set_(set),
      squared_bound_(bound * bound),
      first_(reader.mesh().capacity(2), no_index) {
  const Mesh& mesh = reader.mesh();
  std::vector<bool> seen(reader.tree().mesh(reader.texture(set)).capacity(0), false);
  SurfaceTriangle t;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    reader.read(mesh.dart_of(2, f), t);
    if (t.sets[set].facet == no_index) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Index w = t.sets[set].vertices[i];
      if (!seen[w]) add_point(t, i);
      seen[w] = true;
    }
  }
}

void TextureDistance::add_point(const SurfaceTriangle& t, std::size_t corner) {
  points_.push_back({t.positions[corner], t.sets[set_].texcoords[corner], first_[t.facet]});
  first_[t.facet] = static_cast<Index>(points_.size() - 1);
}

bool TextureDistance::allows(const PredictedStar& star, const CollapsePlan&) {
  moves_.clear();
  for (const PredictedStar::Face& f : star.faces()) {
    if (!f.changes) continue;
    for (Index p = first_[f.before.facet]; p != no_index; p = points_[p].next)
      if (!find_triangle(star, p)) return false;
  }
  return true;
}

/// Of the chart's triangles, the one that is nearest in the texture paints the point.
bool TextureDistance::find_triangle(const PredictedStar& star, Index point) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Nearness best{infinity, infinity};
  Index triangle = no_index;
  for (const PredictedStar::Face& g : star.faces()) {
    if (g.dies || g.before.sets[set_].facet == no_index) continue;
    const Nearness n = nearness(points_[point], g);
    if (n.in_texture < best.in_texture) best = n, triangle = g.before.facet;
  }
  if (triangle == no_index || !(best.in_space <= squared_bound_)) return false;
  moves_.push_back({point, triangle});
  return true;
}

TextureDistance::Nearness TextureDistance::nearness(const Point& p, const PredictedStar::Face& after) const {
  const auto in_texture =
      spatial::closest_point(multimesh::in_space(p.texcoord), in_space(after.texcoords_after(set_)));
  const Vec3 place = spatial::at(after.positions_after(), in_texture.barycentric);
  return {in_texture.squared_distance, (Vec3(place[0], place[1], place[2]) - p.position).squared_norm()};
}

void TextureDistance::collapsed(const PredictedStar& star, const CollapsePlan&) {
  for (const PredictedStar::Face& f : star.faces())
    if (f.changes) first_[f.before.facet] = no_index;
  for (const Move& m : moves_) {
    points_[m.point].next = first_[m.triangle];
    first_[m.triangle] = m.point;
  }
}

}  // namespace multimesh::decimation
