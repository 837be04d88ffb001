// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/embree/pieces.hpp"

#include <algorithm>
#include <cmath>

namespace multimesh::spatial {

namespace {

/// The squared length of the longest side over the area above which a triangle is cut.
constexpr double thin = 16;
/// Limits of the additional pieces: so many per triangle, plus so many in any case.
constexpr double pieces_each = 2, pieces_any = 100000;

double squared(const Vec3& a, const Vec3& b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

/// The corner at which the longest side begins.
std::size_t longest_side(const Triangle& t) {
  const double s[] = {squared(t[0], t[1]), squared(t[1], t[2]), squared(t[2], t[0])};
  return static_cast<std::size_t>(std::max_element(s, s + 3) - s);
}

double area(const Triangle& t) {
  const Vec3 &a = t[0], &b = t[1], &c = t[2];
  const double u[] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  return std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
}

class Cutter {
 public:
  explicit Cutter(const std::vector<Triangle>& triangles) : triangles_(triangles) {}

  std::vector<Piece> run() {
    double all = 0, longest = 0;  // of triangles that may be cut
    for (const Triangle& t : triangles_)
      if (const double l = squared_length(t); l > thin * area(t)) {
        all += std::sqrt(l);
        longest = std::max(longest, std::sqrt(l));
      }
    const auto n = static_cast<double>(triangles_.size());
    // Halving makes fewer than 2 l / shortest_ pieces of a triangle of length l.
    shortest_ = std::max(2 * all / (pieces_each * n + pieces_any), longest / std::sqrt(n));
    result_.reserve(triangles_.size());
    for (Index f = 0; f < triangles_.size(); ++f) add({triangles_[f], f}, area(triangles_[f]));
    return std::move(result_);
  }

 private:
  static double squared_length(const Triangle& t) {
    const std::size_t i = longest_side(t);
    return squared(t[i], t[(i + 1) % 3]);
  }

  void add(const Piece& p, double area) {
    const std::size_t i = longest_side(p.triangle);
    const Vec3 &a = p.triangle[i], &b = p.triangle[(i + 1) % 3], &c = p.triangle[(i + 2) % 3];
    const double length = squared(a, b);
    if (!(length > thin * area && length > shortest_ * shortest_)) {
      result_.push_back(p);
      return;
    }
    const Vec3 middle = at({a, b, c}, {0.5, 0.5, 0});
    add({{a, middle, c}, p.facet}, area / 2);
    add({{middle, b, c}, p.facet}, area / 2);
  }

  const std::vector<Triangle>& triangles_;
  double shortest_ = 0;
  std::vector<Piece> result_;
};

}  // namespace

std::vector<Piece> pieces(const std::vector<Triangle>& triangles) {
  return Cutter(triangles).run();
}

}  // namespace multimesh::spatial
