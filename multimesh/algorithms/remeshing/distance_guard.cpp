// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/distance_guard.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "multimesh/algorithms/to_point.hpp"

namespace multimesh::remeshing {

using OpenMesh::Vec3d;

namespace {

/// Of the angle between a triangle and the mean of those around it, from which on it is compared with the
/// input.
constexpr double bent_cosine = 0.9;
/// Of the bound: a triangle is compared at four points, and may be farther in between.
constexpr double few_points = 0.6;

Vec3d normal(const spatial::Triangle& t) {
  const Vec3d a(t[0].data()), b(t[1].data()), c(t[2].data());
  return cross(b - a, c - a);
}

}  // namespace

DistanceGuard::DistanceGuard(const Mesh& root, const Coordinates& positions, const Reference& input,
                             double bound, double spacing)
    : root_(root), positions_(positions), input_(input), bound_(bound), first_(root.capacity(2), 0) {
  std::vector<bool> known(root.capacity(0), false);
  for (Index f = 0; f < root.capacity(2); ++f) {
    if (!root.is_live(2, f)) continue;
    std::array<Index, 4> v{};
    root.vertices(root.dart_of(2, f), v.data());
    for (std::size_t i = 0; i < 3; ++i)
      if (!known[v[i]]) {
        known[v[i]] = true;
        points_.push_back(to_point(positions.at(v[i])));
        put(static_cast<Index>(points_.size() - 1), f);
      }
    add_points(f, spacing);
  }
}

// A grid of points inside; none in a triangle that is small beside the spacing.
void DistanceGuard::add_points(Index facet, double spacing) {
  const spatial::Triangle t = triangle(root_.dart_of(2, facet));
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest = std::max(longest, (Vec3d(t[i].data()) - Vec3d(t[(i + 1) % 3].data())).norm());
  if (longest < spacing) return;
  const int n = static_cast<int>(std::min(1000.0, std::ceil(longest / spacing)));
  for (int i = 0; i < n; ++i)
    for (int j = 0; i + j < n; ++j) {
      const double u = (i + 1.0 / 3) / n, v = (j + 1.0 / 3) / n;
      points_.push_back(spatial::at(t, {1 - u - v, u, v}));
      put(static_cast<Index>(points_.size() - 1), facet);
    }
}

spatial::Triangle DistanceGuard::triangle(Dart d) const {
  std::array<Index, 4> v{};
  root_.vertices(d, v.data());
  return {to_point(positions_.at(v[0])), to_point(positions_.at(v[1])), to_point(positions_.at(v[2]))};
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
    const Index f = root_.facet(t);
    if (f >= first_.size()) continue;
    for (Index p = first_[f]; p != 0; p = next_[p - 1]) taken_.push_back({p - 1, f});
    first_[f] = 0;
  }
}

void DistanceGuard::give_back() {
  for (const Taken& t : taken_) put(t.point, t.triangle);
}

bool DistanceGuard::settle(const DartBuffer& triangles) {
  std::vector<spatial::Triangle> candidates;
  for (const Dart t : triangles) candidates.push_back(triangle(t));
  settled_.clear();
  const double very_near = bound_ * bound_ / 64;  // no need to look for the nearest one
  for (const Taken& taken : taken_) {
    double least = bound_ * bound_;
    Index nearest = no_index;
    for (std::size_t i = 0; i < candidates.size() && least > very_near; ++i)
      if (const double d = spatial::closest_point(points_[taken.point], candidates[i]).squared_distance;
          d <= least)
        least = d, nearest = root_.facet(triangles[i]);
    if (nearest == no_index) return false;
    settled_.push_back(nearest);
  }
  if (!is_near_input(triangles)) return false;
  for (std::size_t i = 0; i < taken_.size(); ++i) put(taken_[i].point, settled_[i]);
  taken_.clear();
  return true;
}

// A triangle may reach over a bay of the boundary without bending.
bool DistanceGuard::touches_boundary(Dart d) const {
  return root_.is_boundary(d, 1) || root_.is_boundary(root_.reorder(d, edge_ax), 1) ||
         root_.is_boundary(root_.reorder(d, edge_bx), 1);
}

bool DistanceGuard::is_near_input(const DartBuffer& triangles) const {
  Vec3d mean(0, 0, 0);
  for (const Dart t : triangles) mean += normal(triangle(t));
  for (const Dart d : triangles) {
    const spatial::Triangle t = triangle(d);
    const Vec3d n = normal(t);
    if (!touches_boundary(d) && (n | mean) > bent_cosine * n.norm() * mean.norm()) continue;
    for (const auto& w : {std::array{1 / 3.0, 1 / 3.0, 1 / 3.0}, std::array{0.5, 0.5, 0.0},
                          std::array{0.0, 0.5, 0.5}, std::array{0.5, 0.0, 0.5}})
      if (!input_.has_within(spatial::at(t, w), few_points * bound_)) return false;
  }
  return true;
}

}  // namespace multimesh::remeshing
