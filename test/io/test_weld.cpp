// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "adapters/io/weld.hpp"

namespace multimesh::io::test {
namespace {

using Point = std::array<double, 3>;
using Points = std::vector<Point>;

double distance(const Point& p, const Point& q) {
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

/// As specified in the header, by comparing all pairs.
std::vector<std::uint32_t> by_all_pairs(const Points& points, double tolerance) {
  std::vector<std::uint32_t> joins(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    joins[i] = i;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t j = 0; j < i; ++j) {
      const double d = distance(points[i], points[j]);
      if (joins[j] != j || d > tolerance || d >= least) continue;
      least = d;
      joins[i] = j;
    }
  }
  return joins;
}

/// Points about `count` places, in random order, each some times, moved by up to `noise`.
Points scattered(std::mt19937& random, std::size_t count, double noise, double scale) {
  std::uniform_real_distribution<double> place(-scale, scale), off(-noise, noise);
  Points places(count);
  for (Point& p : places) p = {place(random), place(random), place(random)};
  Points points;
  for (std::size_t i = 0; i < 4 * count; ++i) {
    Point p = places[random() % count];
    if (noise > 0)
      for (double& x : p) x += off(random);
    points.push_back(p);
  }
  return points;
}

TEST(CoincidentPoints, AreThoseOfAllPairs) {
  std::mt19937 random(7);
  for (int round = 0; round < 40; ++round) {
    const double scale = std::pow(10.0, static_cast<double>(round % 9) - 4);
    const Points exact = scattered(random, 40, 0, scale);
    EXPECT_EQ(coincident_points(exact), by_all_pairs(exact, 0));
    for (const double tolerance : {1e-6 * scale, 0.05 * scale, 0.6 * scale, 10 * scale}) {
      const Points points = scattered(random, 40, tolerance, scale);
      EXPECT_EQ(coincident_points(points, tolerance), by_all_pairs(points, tolerance)) << tolerance;
    }
  }
}

TEST(CoincidentPoints, ZeroHasNoSignAndNanNoPlace) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Points points{{0, 1, 2}, {-0.0, 1, 2}, {nan, 0, 0}, {nan, 0, 0}, {inf, 0, 0}, {inf, 0, 0}};
  for (const double tolerance : {0.0, 0.5})
    EXPECT_EQ(coincident_points(points, tolerance), (std::vector<std::uint32_t>{0, 0, 2, 3, 4, 5}));
}

// 0---1---2---3: each within the tolerance of the next. Chains would make one point of them.
TEST(CoincidentPoints, MakeNoChains) {
  const Points points{{0, 0, 0}, {0.9, 0, 0}, {1.8, 0, 0}, {2.7, 0, 0}};
  EXPECT_EQ(coincident_points(points, 1), (std::vector<std::uint32_t>{0, 0, 2, 2}));
}

TEST(CoincidentPoints, ToleranceBelowTheSpacingOfNumbers) {
  const Points points{{1e18, 0, 0}, {1e18, 0, 0}, {1.1e18, 0, 0}};
  EXPECT_EQ(coincident_points(points, 1e-9), (std::vector<std::uint32_t>{0, 0, 2}));
}

}  // namespace
}  // namespace multimesh::io::test
