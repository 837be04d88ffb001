// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/star_shape.hpp"

#include <algorithm>
#include <cmath>

namespace multimesh::remeshing {

using OpenMesh::Vec3d;

namespace {

using Corners = std::array<Vec3d, 3>;

/// Of the angle by which a normal may turn in one step.
constexpr double least_cosine = 0.3;

/// Triangles that are flatter or thinner than this are not made; nor flatter or thinner ones of those that
/// are.
constexpr double flat = 0.15, thin = 0.05;
/// By how much a thin triangle may get thinner still: along a strip of needles it leans more and more, until
/// one of them is left.
constexpr double leaning = 0.8;

/// Flatness from which on a normal is more than the noise of the coordinates.
constexpr double with_normal = 1e-5;

struct Form {
  double flatness;  ///< the sine of the largest angle: 0.87 if equilateral, 1 of a needle with a right angle
  double thinness;  ///< twice the area over the square of the longest edge: 0.87 if equilateral
};

/// `n`: the cross product of two edges.
Form form(const Corners& t, const Vec3d& n) {
  std::array<double, 3> squared{(t[1] - t[0]).sqrnorm(), (t[2] - t[1]).sqrnorm(), (t[0] - t[2]).sqrnorm()};
  std::sort(squared.begin(), squared.end());
  const double shorter = std::sqrt(squared[0] * squared[1]), area = n.norm();
  return {shorter > 0 ? area / shorter : 0, squared[2] > 0 ? area / squared[2] : 0};
}

Vec3d normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return cross(b - a, c - a);
}

bool same_side(const Corners& before, const Corners& after) {
  const Vec3d n = normal(before[0], before[1], before[2]), m = normal(after[0], after[1], after[2]);
  const Form was = form(before, n), is = form(after, m);
  if (was.flatness < with_normal) return true;
  if (is.flatness < std::min(flat, was.flatness) || is.thinness < std::min(thin, leaning * was.thinness))
    return false;
  return (n | m) > least_cosine * n.norm() * m.norm();
}

}  // namespace

bool StarShape::allows(Dart vertex, const Vec3d& to, Index without) {
  mesh_.star(vertex, 0, star_);
  for (const Dart t : star_) {
    std::array<Index, 4> v{};
    mesh_.vertices(t, v.data());
    if (v[1] == without || v[2] == without) continue;
    const Vec3d x = at_.at(v[1]), y = at_.at(v[2]);
    if (!same_side({at_.at(v[0]), x, y}, {to, x, y})) return false;
  }
  return true;
}

bool StarShape::allows_swap(Dart edge) {
  mesh_.star(edge, 1, star_);
  if (star_.size() != 2) return false;
  std::array<Index, 4> v{}, w{};
  mesh_.vertices(star_[0], v.data());
  mesh_.vertices(star_[1], w.data());
  const Vec3d a = at_.at(v[0]), b = at_.at(v[1]), l = at_.at(v[2]), r = at_.at(w[2]);
  const Corners left{a, b, l}, right{b, a, r}, low{a, r, l}, high{r, b, l};
  for (const Corners& before : {left, right})
    for (const Corners& after : {low, high})
      if (!same_side(before, after)) return false;
  return same_side(left, right);
}

double least_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const auto at = [](const Vec3d& p, const Vec3d& q, const Vec3d& r) {
    return std::atan2(cross(q - p, r - p).norm(), (q - p) | (r - p));
  };
  return std::min({at(a, b, c), at(b, c, a), at(c, a, b)});
}

}  // namespace multimesh::remeshing
