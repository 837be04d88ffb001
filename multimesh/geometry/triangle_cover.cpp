// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/geometry/triangle_cover.hpp"

#include <bit>

namespace multimesh::spatial {

namespace {

/// How often a triangle is cut in two until each part has one witness near all of it. Ten cuts,
/// if all are in the middle, make parts of 1/32 of the size; more were not seen to help.
constexpr int max_bisections = 10;

double squared_distance(const Vec3& p, const Vec3& q) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
  return sum;
}

Vec3 between(const Vec3& p, const Vec3& q, double t) {
  return {p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1]), p[2] + t * (q[2] - p[2])};
}

}  // namespace

NearTriangles::Mask TriangleCover::choose(NearTriangles::Mask near_all,
                                          const std::array<std::size_t, 3>& nearest) {
  for (const std::size_t n : nearest)
    if (const NearTriangles::Mask m = NearTriangles::Mask{1} << n; near_all & m) return m;
  return near_all & (~near_all + 1);
}

bool TriangleCover::find(const CoveredPart& part, NearTriangles::Mask& chosen) const {
  return part[0].near.mask && part[1].near.mask && part[2].near.mask && find(part, max_bisections, chosen);
}

/// Whether a part is near the union of the chosen candidates, of which more may be chosen as long as there
/// are not too many.
bool TriangleCover::find(const CoveredPart& part, int bisections, NearTriangles::Mask& chosen) const {
  const NearTriangles::Mask near_all = part[0].near.mask & part[1].near.mask & part[2].near.mask;
  if (near_all & chosen) return true;
  if (near_all && static_cast<std::size_t>(std::popcount(chosen)) < Witnesses::most) {
    chosen |= choose(near_all, {part[0].near.nearest, part[1].near.nearest, part[2].near.nearest});
    return true;
  }
  if (bisections == 0) return false;
  const std::size_t i = edge_to_divide(part), j = (i + 1) % 3;
  const CoveredCorner m = divide(part[i], part[j]);
  if (!m.near.mask) return false;
  CoveredPart at_i = part, at_j = part;
  at_i[j] = at_j[i] = m;
  return find(at_i, bisections - 1, chosen) && find(at_j, bisections - 1, chosen);
}

/// The longest of those that have no candidate near both ends, if there are such edges.
std::size_t TriangleCover::edge_to_divide(const CoveredPart& part) {
  std::size_t best = 0;
  double longest = -1;
  bool best_is_covered = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const CoveredCorner &p = part[i], &q = part[(i + 1) % 3];
    const bool is_covered = (p.near.mask & q.near.mask) != 0;
    const double length = squared_distance(p.position, q.position);
    if (is_covered == best_is_covered ? length <= longest : is_covered) continue;
    best = i, longest = length, best_is_covered = is_covered;
  }
  return best;
}

/// A point of an edge: where it passes from candidates near p to others, for in a plane no other point will
/// do; or its middle.
CoveredCorner TriangleCover::divide(const CoveredCorner& p, const CoveredCorner& q) const {
  const auto at = [&](double t) {
    const Vec3 m = between(p.position, q.position, t);
    return CoveredCorner{m, candidates_.near(m)};
  };
  if (!(p.near.mask & q.near.mask)) {
    const double t = candidates_.leaves(p.near.mask, p.position, q.position);
    const CoveredCorner m = at(t);
    if (t > 0 && t < 1 && (m.near.mask & p.near.mask) && (m.near.mask & q.near.mask)) return m;
  }
  return at(0.5);
}

Witnesses::Set TriangleCover::named(NearTriangles::Mask chosen) const {
  Witnesses::Set set;
  set.fill(no_index);
  for (std::size_t i = 0; chosen != 0; chosen &= chosen - 1)
    set[i++] = candidates_.name(static_cast<std::size_t>(std::countr_zero(chosen)));
  return set;
}

}  // namespace multimesh::spatial
