// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/exact/point.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "adapters/exact/fractions.hpp"
#include "multimesh/error.hpp"
#include "multimesh/geometry/orient3d.hpp"

namespace multimesh::exact {

namespace {

/// GMP rounds towards 0.
double nearest_double(const Rational& x) {
  const double low = x.get_d();
  const double high = std::nextafter(
      low, x < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity());
  if (!std::isfinite(high)) return low;
  const Rational below = abs(x - Rational(low)), above = abs(Rational(high) - x);
  return below <= above ? low : high;
}

Point make(const RationalPoint& x) {
  Point::Fractions f;
  f.w = lcm(lcm(x[0].get_den(), x[1].get_den()), x[2].get_den());
  for (std::size_t i = 0; i < 3; ++i) f.x[i] = x[i].get_num() * (f.w / x[i].get_den());
  return Point(std::make_shared<const Point::Fractions>(std::move(f)));
}

RationalPoint along(const RationalPoint& a, const RationalPoint& way, const Rational& t) {
  return {a[0] + t * way[0], a[1] + t * way[1], a[2] + t * way[2]};
}

/// The axis along which a vector is longest.
std::size_t longest(const RationalPoint& v) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (abs(v[i]) > abs(v[k])) k = i;
  return k;
}

/// The sign that the nearest doubles decide, or 0. With u = 2^-53, each difference of two coordinates x, y is
/// wrong by at most 2u (|x| + |y|), of which the coordinates themselves have a half: so each of the six
/// products of three by at most 6u of the product of those sums, to first order, and the sum of six rounded
/// products by less than 8u more.
int sign_of_nearest(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  constexpr double bound = 20 * 0x1p-53;
  const Vec3 p = b - a, q = c - a, r = d - a;
  const auto sum = [&](const Vec3& x) {
    return Vec3(std::abs(x[0]) + std::abs(a[0]), std::abs(x[1]) + std::abs(a[1]),
                std::abs(x[2]) + std::abs(a[2]));
  };
  const Vec3 s = sum(b), t = sum(c), w = sum(d);
  const double det = p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                     p[2] * (q[0] * r[1] - q[1] * r[0]);
  const double all = s[0] * (t[1] * w[2] + t[2] * w[1]) + s[1] * (t[2] * w[0] + t[0] * w[2]) +
                     s[2] * (t[0] * w[1] + t[1] * w[0]);
  // Below, products may underflow.
  if (!(all > 1e-250) || !std::isfinite(all)) return 0;
  return det > bound * all ? 1 : det < -bound * all ? -1 : 0;
}

}  // namespace

Point::Point(std::shared_ptr<const Fractions> fractions) : fractions_(std::move(fractions)) {
  const RationalPoint x = rational(*this);
  bool same = true;
  for (std::size_t i = 0; i < 3; ++i) {
    nearest_[i] = nearest_double(x[i]);
    same = same && x[i] == Rational(nearest_[i]);
  }
  if (same) fractions_.reset();
}

std::size_t Point::bits() const {
  if (is_double()) return 53;
  std::size_t most = mpz_sizeinbase(fractions_->w.get_mpz_t(), 2);
  for (const mpz_class& x : fractions_->x) most = std::max(most, mpz_sizeinbase(x.get_mpz_t(), 2));
  return most;
}

Decisions& decisions() {
  thread_local Decisions all;
  return all;
}

int orient3d(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (a.is_double() && b.is_double() && c.is_double() && d.is_double()) {
    ++decisions().doubles;
    return multimesh::orient3d(a.nearest().data(), b.nearest().data(), c.nearest().data(),
                               d.nearest().data());
  }
  if (const int s = sign_of_nearest(a.nearest(), b.nearest(), c.nearest(), d.nearest())) {
    ++decisions().nearest;
    return s;
  }
  ++decisions().fractions;
  return sign_of_fractions(a, b, c, d);
}

Point crossing(const Point& a, const Point& b, const Point& c, const Point& d, const Point& e) {
  const RationalPoint from = rational(a), way = rational(b) - from, o = rational(c);
  const RationalPoint normal = cross(rational(d) - o, rational(e) - o);
  const Rational along_normal = dot(normal, way);
  if (along_normal == 0) throw UsageError("crossing: the line is parallel to the plane");
  return make(along(from, way, dot(normal, o - from) / along_normal));
}

Point on_segment(const Point& a, const Point& b, double t) {
  const RationalPoint from = rational(a);
  return make(along(from, rational(b) - from, Rational(t)));
}

double position_on_segment(const Point& p, const Point& a, const Point& b) {
  const RationalPoint from = rational(a), way = rational(b) - from;
  const std::size_t k = longest(way);
  const Rational t = (rational(p)[k] - from[k]) / way[k];
  return t.get_d();
}

Point in_plane(const Point& a, const Point& b, const Point& c, double u, double v) {
  const RationalPoint o = rational(a);
  return make(along(along(o, rational(b) - o, Rational(u)), rational(c) - o, Rational(v)));
}

std::array<double, 2> position_in_plane(const Point& p, const Point& a, const Point& b, const Point& c) {
  const RationalPoint o = rational(a), to_b = rational(b) - o, to_c = rational(c) - o, way = rational(p) - o;
  const RationalPoint normal = cross(to_b, to_c);
  const std::size_t k = longest(normal);
  const Rational u = cross(way, to_c)[k] / normal[k], v = cross(to_b, way)[k] / normal[k];
  return {u.get_d(), v.get_d()};
}

bool equal(const Point& p, const Point& q) {
  if (p.is_double() && q.is_double()) return p.nearest() == q.nearest();
  return !p.is_double() && !q.is_double() && rational(p) == rational(q);
}

}  // namespace multimesh::exact
