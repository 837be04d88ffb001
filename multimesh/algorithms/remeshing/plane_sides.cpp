// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/plane_sides.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/geometry/orient2d.hpp"

namespace multimesh::remeshing {

namespace {

/// Twice an area that counts as none, relative to the squared diagonal of the bounding box.
constexpr double relative_tiny = 1e-11;

int side(const Corners& t) {
  return orient2d(t[0].data(), t[1].data(), t[2].data());
}

double doubled_area(const Corners& t) {
  const Vec3 u = t[1] - t[0], v = t[2] - t[0];
  return std::abs(u[0] * v[1] - u[1] * v[0]);
}

}  // namespace

PlaneSides::PlaneSides(const Mesh& mesh, const Coordinates& at) : mesh_(mesh), at_(at) {
  Vec3 low(HUGE_VAL, HUGE_VAL, 0), high(-HUGE_VAL, -HUGE_VAL, 0);
  for (Index v = 0; v < mesh.capacity(0); ++v)
    if (mesh.is_live(0, v)) low = min(low, at.at(v)), high = max(high, at.at(v));
  if (low[0] <= high[0]) tiny_ = relative_tiny * (high - low).squared_norm();
}

// In the orientation of the mesh, whatever that of the dart.
Corners PlaneSides::triangle(Dart d) const {
  std::array<Index, 4> v{};
  mesh_.vertices(mesh_.dart_of(2, mesh_.facet(d)), v.data());
  return {at_.at(v[0]), at_.at(v[1]), at_.at(v[2])};
}

bool PlaneSides::keeps_side(const Corners& before, const Corners& after, int none) const {
  const int had = side(before), has = side(after);
  if (had == 0 ? has != 0 && has != none : has != had) return false;
  return doubled_area(before) <= tiny_ || doubled_area(after) > tiny_;
}

int PlaneSides::common_side() const {
  int common = 0;
  for (const Dart t : star_) {
    const int s = side(triangle(t));
    if (s != 0 && s == -common) return 0;
    if (s != 0) common = s;
  }
  return common;
}

bool PlaneSides::allows(Dart vertex, const Vec3& to, Index without) {
  mesh_.star(vertex, 0, star_);
  const int common = common_side();
  return keeps_around(mesh_, at_, star_, to, without, [&](const Corners& before, const Corners& after) {
    return keeps_side(before, after, common);
  });
}

bool PlaneSides::allows_swap(Dart edge) {
  mesh_.star(edge, 1, star_);
  if (star_.size() != 2) return false;
  const Swapped t(mesh_, at_, star_);
  const int sum = side(t.left) + side(t.right);
  if (sum == 0) return false;
  const int common = sum > 0 ? 1 : -1;
  return t.keeps_all(
      [&](const Corners& before, const Corners& after) { return keeps_side(before, after, common); });
}

void PlaneSides::count(Dart d, int k, Count& sum) {
  mesh_.star(d, k, star_);
  for (const Dart t : star_) {
    const Corners corners = triangle(t);
    const int s = side(corners);
    sum.left += s > 0, sum.right += s < 0, sum.none += s == 0;
    sum.tiny += doubled_area(corners) <= tiny_;
  }
}

bool PlaneSides::halved(const Count& before, const Count& after) {
  const bool none_may_be_left = before.right == 0 && before.left > 0;
  const bool none_may_be_right = before.left == 0 && before.right > 0;
  return after.left >= 2 * before.left && (after.left == 2 * before.left || none_may_be_left) &&
         after.right >= 2 * before.right && (after.right == 2 * before.right || none_may_be_right) &&
         after.tiny <= 2 * before.tiny;
}

}  // namespace multimesh::remeshing
