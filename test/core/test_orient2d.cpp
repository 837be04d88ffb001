// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "multimesh/geometry/orient2d.hpp"

namespace multimesh {
namespace {

__extension__ using Wide = __int128;
using Whole = std::int64_t;

struct Point {
  Whole x, y;
};

int by_integers(const Point& a, const Point& b, const Point& c) {
  const Wide det = Wide(b.x - a.x) * (c.y - a.y) - Wide(b.y - a.y) * (c.x - a.x);
  return (det > 0) - (det < 0);
}

int scaled(const Point& a, const Point& b, const Point& c, int exponent) {
  const auto x = [&](Whole w) { return std::ldexp(static_cast<double>(w), exponent); };
  const double p[2] = {x(a.x), x(a.y)}, q[2] = {x(b.x), x(b.y)}, r[2] = {x(c.x), x(c.y)};
  return orient2d(p, q, r);
}

TEST(Orient2d, SaysLeftRightAndStraightOn) {
  const double o[2] = {0, 0}, x[2] = {1, 0}, y[2] = {0, 1};
  EXPECT_EQ(orient2d(o, x, y), 1);
  EXPECT_EQ(orient2d(o, y, x), -1);
  EXPECT_EQ(orient2d(o, x, x), 0);
}

// Nearly on one line, where double precision alone is wrong, at all scales that keep the numbers exact.
TEST(Orient2d, AgreesWithIntegerArithmetic) {
  std::mt19937_64 random(7);
  int straight = 0;
  for (int i = 0; i < 20000; ++i) {
    const int digits = 2 + static_cast<int>(random() % 50);
    const auto number = [&] { return static_cast<Whole>(random() % (Whole{1} << digits)); };
    const Point a{number(), number()}, step{number() >> 4, number() >> 4};
    const auto along = [&](Whole n) {
      return Point{a.x + n * step.x + static_cast<Whole>(random() % 3) - 1,
                   a.y + n * step.y + static_cast<Whole>(random() % 3) - 1};
    };
    const Point b = along(3), c = along(7);
    const int right = by_integers(a, b, c);
    straight += right == 0;
    for (const int exponent : {0, -60, -560, -1020, -1074, 400, 960}) {
      EXPECT_EQ(scaled(a, b, c, exponent), right) << i << " at 2^" << exponent;
      EXPECT_EQ(scaled(b, a, c, exponent), -right) << i << " at 2^" << exponent;
    }
  }
  EXPECT_GT(straight, 100);
}

TEST(Orient2d, HoldsAtTheEndsOfTheRange) {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  const double o[2] = {0, 0}, a[2] = {least, 0}, b[2] = {0, least}, p[2] = {-most, -most},
               q[2] = {most, most};
  EXPECT_EQ(orient2d(o, a, b), 1);
  EXPECT_EQ(orient2d(p, q, o), 0);
  EXPECT_EQ(orient2d(p, q, a), -1);  // least below the diagonal
  EXPECT_EQ(orient2d(p, q, b), 1);
}

}  // namespace
}  // namespace multimesh
