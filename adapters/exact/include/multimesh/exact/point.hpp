// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <memory>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::exact {

/// A point of space with rational coordinates. Most are doubles; others are kept as fractions beside the
/// nearest doubles, which decide where they can. Copies share the fractions.
class Point {
 public:
  /// Finite doubles; exact.
  Point(const Vec3& p) : nearest_(p) {}

  /// Each coordinate is the double nearest to the true one.
  const Vec3& nearest() const noexcept { return nearest_; }
  /// Whether it is the point nearest().
  bool is_double() const noexcept { return fractions_ == nullptr; }
  /// The binary digits of the longest numerator or of the common denominator; 53 for doubles.
  std::size_t bits() const;

  struct Fractions;  ///< private to the implementation
  explicit Point(std::shared_ptr<const Fractions> fractions);
  const Fractions* fractions() const noexcept { return fractions_.get(); }

 private:
  Vec3 nearest_;
  std::shared_ptr<const Fractions> fractions_;  // none: a double
};

/// The sign of det(b-a, c-a, d-a), as multimesh::orient3d. Cost: some tens of operations where the nearest
/// doubles decide; else that of the fractions, some microseconds. Thread-safe.
int orient3d(const Point& a, const Point& b, const Point& c, const Point& d);

/// Where the line through a and b meets the plane of c, d and e. \throw UsageError if they are parallel, or
/// c, d and e collinear
Point crossing(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e);

/// a + t (b - a).
Point on_segment(const Point& a, const Point& b, double t);
/// The t of the point of the line through a and b that is p, rounded towards 0. \pre p is on the line, a != b
double position_on_segment(const Point& p, const Point& a, const Point& b);

/// a + u (b - a) + v (c - a).
Point in_plane(const Point& a, const Point& b, const Point& c, double u, double v);
/// The u and v of a point in the plane of a, b and c, rounded towards 0. \pre it is there, and they are not
/// collinear
std::array<double, 2> position_in_plane(const Point& p, const Point& a, const Point& b, const Point& c);

/// Whether they are the same point; exact.
bool equal(const Point& p, const Point& q);

/// How often orient3d was decided by what, in this thread: for measurements.
struct Decisions {
  std::size_t doubles = 0, nearest = 0, fractions = 0;
};
Decisions& decisions();

}  // namespace multimesh::exact
