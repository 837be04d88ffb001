// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/shape_tests.hpp"

#include <algorithm>

#include "multimesh/geometry/keeps_side.hpp"

namespace multimesh::decimation {

namespace {

double longest_squared(const std::array<Vec3, 3>& p) {
  return std::max({(p[1] - p[0]).squared_norm(), (p[2] - p[1]).squared_norm(), (p[0] - p[2]).squared_norm()});
}

double aspect_ratio(const std::array<Vec3, 3>& p) {
  const double doubled_area = doubled_area_vector(p).norm();
  return doubled_area > 0 ? longest_squared(p) / doubled_area : std::numeric_limits<double>::infinity();
}

double angle_between(const Vec3& x, const Vec3& y) {
  return std::acos(std::clamp(dot(x, y), -1.0, 1.0));
}

}  // namespace

bool NormalTurn::allows(const PredictedStar& star, const CollapsePlan&) {
  for (const PredictedStar::Face& f : star.faces()) {
    if (f.dies || !f.changes) continue;
    const Vec3 before = doubled_area_vector(f.before.positions);
    if (!(before.squared_norm() > 0)) continue;
    const auto positions = f.positions_after();
    const Vec3 after = doubled_area_vector(positions);
    const double has = after.squared_norm(), longest = longest_squared(positions);
    if (has <= 1e-20 * longest * longest) return false;
    if (!turns_at_most(min_cosine_, before, after)) return false;
  }
  return true;
}

bool AspectRatio::allows(const PredictedStar& star, const CollapsePlan&) {
  double had = 0, has = 0;
  for (const PredictedStar::Face& f : star.faces()) {
    if (!f.changes) continue;
    had = std::max(had, aspect_ratio(f.before.positions));
    if (!f.dies) has = std::max(has, aspect_ratio(f.positions_after()));
  }
  return has <= limit_ || has < had;
}

NormalDeviation::NormalDeviation(const TriangleReader& reader, double limit)
    : PlacementTest("normal deviation"), limit_(limit) {
  const Mesh& mesh = reader.mesh();
  cones_.resize(mesh.capacity(2));
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    const Vec3 n = doubled_area_vector(reader.positions(mesh.dart_of(2, f)));
    if (n.norm() > 0) cones_[f] = {n / n.norm(), 0};
  }
}

/// The least cone that holds both.
NormalDeviation::Cone NormalDeviation::join(const Cone& x, const Cone& y) {
  if (x.angle < 0) return y;
  if (y.angle < 0) return x;
  const double between = angle_between(x.axis, y.axis);
  if (between + y.angle <= x.angle) return x;
  if (between + x.angle <= y.angle) return y;
  const double angle = (between + x.angle + y.angle) / 2;
  if (angle >= M_PI) return {x.axis, M_PI};
  // Turned from x's axis towards y's, in their plane.
  Vec3 sideways = y.axis - x.axis * dot(x.axis, y.axis);
  if (!(sideways.norm() > 0)) return {x.axis, M_PI};
  const double turn = angle - x.angle;
  return {x.axis * std::cos(turn) + sideways.normalized() * std::sin(turn), angle};
}

// The area of a dead triangle goes to its neighbours, the triangles that meet at its apex afterwards.
NormalDeviation::Cone NormalDeviation::cone_after(const PredictedStar& star,
                                                  const PredictedStar::Face& face) const {
  Cone cone = cones_[face.before.facet];
  for (const PredictedStar::Face& dead : star.faces()) {
    const Index apex = dead.before.vertices[2];
    if (dead.dies && (face.before.vertices[1] == apex || face.before.vertices[2] == apex))
      cone = join(cone, cones_[dead.before.facet]);
  }
  return cone;
}

bool NormalDeviation::allows(const PredictedStar& star, const CollapsePlan&) {
  for (const PredictedStar::Face& f : star.faces()) {
    if (f.dies) continue;
    const Cone cone = cone_after(star, f);
    const Vec3 n = doubled_area_vector(f.positions_after());
    if (cone.angle < 0 || !(n.norm() > 0)) continue;
    if (angle_between(n / n.norm(), cone.axis) + cone.angle > limit_) return false;
  }
  return true;
}

void NormalDeviation::collapsed(const PredictedStar& star, const CollapsePlan&) {
  for (const PredictedStar::Face& f : star.faces())
    if (!f.dies) cones_[f.before.facet] = cone_after(star, f);
}

}  // namespace multimesh::decimation
