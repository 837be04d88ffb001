// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/distance_guard.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::remeshing {

namespace {

/// Threshold for the cosine of the angle between a triangle and the mean of those around it, below which it
/// is compared with the input.
constexpr double bent_cosine = 0.9;
/// Share of the bound: a triangle is compared at four points, and may be farther in between.
constexpr double few_points = 0.6;
/// Points in a square whose side is the spacing.
constexpr double per_square = 2;

Vec3 normal(const spatial::Triangle& t) {
  return cross(t[1] - t[0], t[2] - t[0]);
}

/// Of the side from corner i to the next one.
double squared_side(const spatial::Triangle& t, std::size_t i) {
  return (t[i] - t[(i + 1) % 3]).squared_norm();
}

}  // namespace

DistanceGuard::DistanceGuard(const Mesh& surface, const Coordinates& positions, const Reference& input,
                             double bound, double spacing)
    : mesh_(surface), positions_(positions), input_(input), bound_(bound), first_(surface.capacity(2), 0) {
  std::vector<bool> known(surface.capacity(0), false);
  for (Index f = 0; f < surface.capacity(2); ++f) {
    if (!surface.is_live(2, f)) continue;
    std::array<Index, 4> v{};
    surface.vertices(surface.dart_of(2, f), v.data());
    for (std::size_t i = 0; i < 3; ++i)
      if (!known[v[i]]) {
        known[v[i]] = true;
        add_point(positions.at(v[i]), f);
      }
    const spatial::Triangle t = triangle(surface.dart_of(2, f));
    for (std::size_t i = 0; i < 3; ++i)
      if (squared_side(t, i) >= spacing * spacing) {
        add_points(t, f, spacing);
        break;
      }
  }
}

// In proportion to the area, whatever the shape: a fraction of a point that remains in one triangle is
// carried over to the next. The places are those of the R2 sequence, folded into the triangle, so that thin
// triangles side by side have them at different places along their length. Source: Roberts, The unreasonable
// effectiveness of quasirandom sequences, 2018.
void DistanceGuard::add_points(const spatial::Triangle& t, Index facet, double spacing) {
  constexpr double u_step = 0.7548776662466927, v_step = 0.5698402909980532;
  due_ += per_square * normal(t).norm() / 2 / (spacing * spacing);
  for (; due_ >= 1; due_ -= 1) {
    u_ = std::fmod(u_ + u_step, 1);
    v_ = std::fmod(v_ + v_step, 1);
    const bool outside = u_ + v_ > 1;
    const double u = outside ? 1 - u_ : u_, v = outside ? 1 - v_ : v_;
    add_point(spatial::at(t, {1 - u - v, u, v}), facet);
  }
}

void DistanceGuard::add_point(const Vec3& p, Index facet) {
  points_.push_back(p);
  put(static_cast<Index>(points_.size() - 1), facet);
}

spatial::Triangle DistanceGuard::triangle(Dart d) const {
  std::array<Index, 4> v{};
  mesh_.vertices(d, v.data());
  return {positions_.at(v[0]), positions_.at(v[1]), positions_.at(v[2])};
}

void DistanceGuard::put(Index p, Index triangle) {
  if (p >= next_.size()) next_.resize(p + 1, 0);
  if (triangle >= first_.size()) first_.resize(triangle + 1, 0);
  next_[p] = first_[triangle];
  first_[triangle] = p + 1;
}

void DistanceGuard::take(const DartBuffer& triangles) {
  taken_.clear();
  for (const Dart t : triangles) {
    const Index f = mesh_.facet(t);
    if (f >= first_.size()) continue;
    for (Index p = first_[f]; p != 0; p = next_[p - 1]) taken_.push_back({p - 1, f});
    first_[f] = 0;
  }
}

void DistanceGuard::give_back() {
  for (const Taken& t : taken_) put(t.point, t.triangle);
}

void DistanceGuard::sort_anew() {
  std::vector<spatial::Triangle> triangles;
  std::vector<Index> facets;
  for (Index f = 0; f < mesh_.capacity(2); ++f) {
    if (!mesh_.is_live(2, f)) continue;
    triangles.push_back(triangle(mesh_.dart_of(2, f)));
    facets.push_back(f);
  }
  const spatial::TriangleTree tree(std::move(triangles));
  std::fill(first_.begin(), first_.end(), 0);
  for (Index p = 0; p < points_.size(); ++p)
    if (const auto found = tree.nearest(points_[p], std::numeric_limits<double>::infinity()))
      put(p, facets[found->facet]);
}

bool DistanceGuard::settle(const DartBuffer& triangles) {
  find_nearest(triangles, bound_);
  if (settled_.size() < taken_.size() || !is_near_input(triangles)) return false;
  put_settled();
  return true;
}

void DistanceGuard::hand_on(const DartBuffer& triangles) {
  find_nearest(triangles, std::numeric_limits<double>::infinity());
  put_settled();
}

// For each point that was taken, as long as there is one within the distance.
void DistanceGuard::find_nearest(const DartBuffer& triangles, double distance) {
  candidates_.clear();
  for (const Dart t : triangles) candidates_.push_back({triangle(t), mesh_.facet(t)});
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& x, const Candidate& y) { return x.facet < y.facet; });
  settled_.clear();
  for (const Taken& taken : taken_) {
    const Index nearest = nearest_candidate(taken, distance);
    if (nearest == no_index) return;
    settled_.push_back(nearest);
  }
}

// The triangle that had the point is tried first: around a vertex with many triangles, others are seldom
// needed.
Index DistanceGuard::nearest_candidate(const Taken& taken, double distance) const {
  const double very_near = bound_ * bound_ / 64;  // no need to search for the nearest one
  double least = distance * distance;
  Index nearest = no_index;
  const auto ask = [&](const Candidate& c) {
    const double d = spatial::closest_point(points_[taken.point], c.triangle).squared_distance;
    if (d <= least) least = d, nearest = c.facet;
  };
  const auto had = std::lower_bound(candidates_.begin(), candidates_.end(), taken.triangle,
                                    [](const Candidate& c, Index facet) { return c.facet < facet; });
  if (had != candidates_.end() && had->facet == taken.triangle) ask(*had);
  for (const Candidate& c : candidates_) {
    if (nearest != no_index && least <= very_near) break;
    ask(c);
  }
  return nearest;
}

void DistanceGuard::put_settled() {
  for (std::size_t i = 0; i < taken_.size(); ++i) put(taken_[i].point, settled_[i]);
  taken_.clear();
}

// A triangle may reach across a bay of the boundary without bending.
bool DistanceGuard::touches_boundary(Dart d) const {
  return mesh_.is_boundary(d, 1) || mesh_.is_boundary(mesh_.reorder(d, edge_ax), 1) ||
         mesh_.is_boundary(mesh_.reorder(d, edge_bx), 1);
}

// At the points of a grid, in addition to the corners.
bool DistanceGuard::is_near_input(const spatial::Triangle& t) const {
  constexpr int n = 4;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n && k <= n - i; ++k) {
      const int m = n - i - k;
      if (m < n && !input_.has_within(spatial::at(t, {i / double(n), k / double(n), m / double(n)}),
                                      few_points * bound_))
        return false;
    }
  return true;
}

bool DistanceGuard::is_near_input(const DartBuffer& triangles) const {
  Vec3 mean(0, 0, 0);
  for (const Dart t : triangles) mean += normal(triangle(t));
  for (const Dart d : triangles) {
    const spatial::Triangle t = triangle(d);
    const Vec3 n = normal(t);
    if (!touches_boundary(d) && dot(n, mean) > bent_cosine * n.norm() * mean.norm()) continue;
    if (!is_near_input(t)) return false;
  }
  return true;
}

}  // namespace multimesh::remeshing
