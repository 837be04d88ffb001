// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/surface_distance.hpp"

#include <algorithm>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::decimation {

namespace {

spatial::Witnesses::Set only(Index witness) {
  spatial::Witnesses::Set set;
  set.fill(no_index);
  set[0] = witness;
  return set;
}

}  // namespace

SurfaceDistance::SurfaceDistance(const TriangleReader& reader, double bound)
    : PlacementTest("maximal error"),
      reader_(reader),
      mesh_(reader.mesh()),
      squared_bound_(bound * bound),
      triangles_(mesh_.capacity(2)),
      witnesses_(mesh_.capacity(2)),
      candidates_(bound) {
  for (Index v = 0; v < mesh_.capacity(0); ++v) vertices_.push_back({reader.positions()[v], 0, {}});
  for (Index t = 0; t < mesh_.capacity(2); ++t) {
    if (!mesh_.is_live(2, t)) continue;
    mesh_.vertices(mesh_.dart_of(2, t), triangles_[t].vertices.data());
    witnesses_.set(t, only(t));
  }
}

bool SurfaceDistance::allows(const PredictedStar& star, const CollapsePlan& plan) {
  ++plan_;
  moves_.clear();
  undecided_.clear();
  read_candidates(star);
  if (!find_witnesses(star)) return false;
  const bool is_new_place = plan.moves(End::a) && plan.moves(End::b);
  return !is_new_place || is_near_input(star, plan.position);
}

void SurfaceDistance::collapsed(const PredictedStar&, const CollapsePlan&) {
  for (const Move& m : moves_) witnesses_.set(m.input, m.witnesses);
}

// Those that change come first: a huge star may have more than there is room for. Leaving some out is safe.
void SurfaceDistance::read_candidates(const PredictedStar& star) {
  constexpr std::size_t room = spatial::NearTriangles::capacity - spatial::Witnesses::most;
  candidates_.shrink(0);
  for (const bool changes : {true, false})
    for (const PredictedStar::Face& f : star.faces()) {
      if (f.dies || f.changes != changes || candidates_.size() == room) continue;
      const auto p = f.positions_after();
      candidates_.add(f.before.facet, {p[0], p[1], p[2]});
    }
  in_star_ = candidates_.size();
}

// Most plans that fail do so at a vertex of the input: the search that takes long comes last.
bool SurfaceDistance::find_witnesses(const PredictedStar& star) {
  for (const PredictedStar::Face& f : star.faces())
    if (f.changes && !witnesses_.all_of(f.before.facet, [this](Index t) { return find_one(t); }))
      return false;
  return std::all_of(undecided_.begin(), undecided_.end(), [&](Index t) { return find_several(star, t); });
}

/// The candidates in the star that are near a vertex of the input: found out once per plan.
const spatial::NearTriangles::Near& SurfaceDistance::near(Vertex& v) {
  if (v.plan != plan_) v.near = candidates_.near(v.position);
  v.plan = plan_;
  return v.near;
}

/// False only if there are no witnesses for this triangle. It may be met several times, once for each of
/// those that change.
bool SurfaceDistance::find_one(Index input) {
  InputTriangle& t = triangles_[input];
  if (t.plan == plan_) return true;
  t.plan = plan_;
  const bool may_have_others = witnesses_.of(input)[1] != no_index;
  const spatial::TriangleCover cover(candidates_);
  Mask near_all = ~Mask{0};
  std::array<std::size_t, 3> nearest;
  for (std::size_t i = 0; i < 3; ++i) {
    const spatial::NearTriangles::Near& at_corner = near(vertices_[t.vertices[i]]);
    if (!at_corner.mask && !may_have_others) return false;
    near_all &= at_corner.mask;
    nearest[i] = at_corner.nearest;
  }
  if (near_all)
    moves_.push_back({input, cover.named(cover.choose(near_all, nearest))});
  else
    undecided_.push_back(input);
  return true;
}

bool SurfaceDistance::find_several(const PredictedStar& star, Index input) {
  spatial::CoveredPart part;
  for (std::size_t i = 0; i < 3; ++i) {
    Vertex& v = vertices_[triangles_[input].vertices[i]];
    part[i] = {v.position, near(v)};
  }
  add_witnesses_elsewhere(star, input);  // for this triangle only
  for (spatial::CoveredCorner& c : part) c.near.mask |= candidates_.near(c.position, in_star_).mask;
  Mask chosen = 0;
  const spatial::TriangleCover cover(candidates_);
  const bool found = cover.find(part, chosen);
  if (found) moves_.push_back({input, cover.named(chosen)});
  candidates_.shrink(in_star_);
  return found;
}

/// Witnesses that do not change, for they are not in the star.
void SurfaceDistance::add_witnesses_elsewhere(const PredictedStar& star, Index input) {
  for (const Index w : witnesses_.of(input)) {
    const auto is_witness = [w](const PredictedStar::Face& f) { return f.before.facet == w; };
    if (w == no_index || std::any_of(star.faces().begin(), star.faces().end(), is_witness)) continue;
    candidates_.add(w, reader_.positions(mesh_.dart_of(2, w)));
  }
}

/// Whether a place is near a triangle of the input, of those that are witnessed in the old star.
bool SurfaceDistance::is_near_input(const PredictedStar& star, const Vec3& position) const {
  const Vec3& p = position;
  const auto is_far = [&](Index input) {
    const auto& v = triangles_[input].vertices;
    const spatial::Triangle t{vertices_[v[0]].position, vertices_[v[1]].position, vertices_[v[2]].position};
    return !(spatial::closest_point(p, t).squared_distance <= squared_bound_);
  };
  return std::any_of(star.faces().begin(), star.faces().end(), [&](const PredictedStar::Face& f) {
    return !witnesses_.all_of(f.before.facet, is_far);
  });
}

}  // namespace multimesh::decimation
