// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/remeshing/star_shape.hpp"

#include <algorithm>
#include <cmath>

#include "multimesh/swapped.hpp"

namespace multimesh::remeshing {

namespace {

/// Bounds the angle by which a normal may turn in one step.
constexpr double least_cosine = 0.3;

/// No triangles flatter or thinner than this are made; existing ones are not made flatter or
/// thinner.
constexpr double flat = 0.15, thin = 0.05;
/// How much thinner a thin triangle may still become: along a strip of needles it leans more and more, until
/// one of them is left.
constexpr double leaning = 0.8;

/// Flatness above which a normal is more than the noise of the coordinates.
constexpr double with_normal = 1e-5;

struct Form {
  double flatness;  ///< the sine of the largest angle: 0.87 if equilateral, 1 of a needle with a right angle
  double thinness;  ///< twice the area over the square of the longest edge: 0.87 if equilateral
};

/// `n`: the cross product of two edges.
Form form(const Corners<3>& t, const Vec3& n) {
  std::array<double, 3> squared{(t[1] - t[0]).squared_norm(), (t[2] - t[1]).squared_norm(),
                                (t[0] - t[2]).squared_norm()};
  std::sort(squared.begin(), squared.end());
  const double shorter = std::sqrt(squared[0] * squared[1]), area = n.norm();
  return {shorter > 0 ? area / shorter : 0, squared[2] > 0 ? area / squared[2] : 0};
}

bool same_side(const Corners<3>& before, const Corners<3>& after) {
  const Vec3 n = doubled_area_vector(before), m = doubled_area_vector(after);
  const Form was = form(before, n), is = form(after, m);
  if (was.flatness < with_normal) return true;
  if (is.flatness < std::min(flat, was.flatness) || is.thinness < std::min(thin, leaning * was.thinness))
    return false;
  return turns_at_most(least_cosine, n, m);
}

}  // namespace

bool StarShape::allows(Dart vertex, const Vec3& to, Index without) {
  mesh_.star(vertex, 0, star_);
  return std::ranges::all_of(star_, [&](Dart t) {
    std::array<Index, 4> v{};
    mesh_.vertices(t, v.data());
    if (v[1] == without || v[2] == without) return true;
    const Vec3 x = at_.at(v[1]), y = at_.at(v[2]);
    return same_side({at_.at(v[0]), x, y}, {to, x, y});
  });
}

bool StarShape::allows_swap(Dart edge) {
  mesh_.star(edge, 1, star_);
  if (star_.size() != 2) return false;
  const Swapped t(mesh_, at_, star_);
  return t.keeps_all(same_side) && same_side(t.left, t.right);
}

bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Corners<3> t{a, b, c};
  return form(t, doubled_area_vector(t)).flatness < flat;
}

// The angle opposite the shortest side.
double least_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const auto at = [](const Vec3& p, const Vec3& q, const Vec3& r) {
    return std::atan2(cross(q - p, r - p).norm(), dot(q - p, r - p));
  };
  const double ab = (b - a).squared_norm(), bc = (c - b).squared_norm(), ca = (a - c).squared_norm();
  return ab <= bc && ab <= ca ? at(c, a, b) : bc <= ca ? at(a, b, c) : at(b, c, a);
}

}  // namespace multimesh::remeshing
