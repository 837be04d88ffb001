// SPDX-License-Identifier: BSD-3-Clause
// Closest points by the tree against all triangles, one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <random>
#include <thread>

#include "multimesh/error.hpp"
#include "multimesh/spatial/triangle_tree.hpp"

namespace multimesh::spatial {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Random numbers that are the same on all platforms.
class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Vec3 point(const Vec3& low, const Vec3& high) {
    return {(*this)(low[0], high[0]), (*this)(low[1], high[1]), (*this)(low[2], high[2])};
  }

 private:
  std::mt19937_64 engine_;
};

std::vector<Triangle> soup(std::size_t n, unsigned seed, double size, const Vec3& low, const Vec3& high) {
  Random random(seed);
  std::vector<Triangle> triangles(n);
  for (Triangle& t : triangles) {
    t[0] = random.point(low, high);
    for (std::size_t i = 1; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        t[i][k] = std::clamp(t[0][k] + random(-size, size), low[k], high[k]);
  }
  return triangles;
}

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Nearby nearest_of_all(const std::vector<Triangle>& triangles, const Vec3& p) {
  Nearby best{no_index, {}, infinity};
  for (Index f = 0; f < triangles.size(); ++f)
    if (const auto q = closest_point(p, triangles[f]); q.squared_distance < best.squared_distance)
      best = {f, q.barycentric, q.squared_distance};
  return best;
}

void expect_equal(const Nearby& a, const Nearby& b) {
  EXPECT_EQ(a.facet, b.facet);
  EXPECT_EQ(a.barycentric, b.barycentric);
  EXPECT_EQ(a.squared_distance, b.squared_distance);
}

/// nearest and within at some points against brute force, to the last bit.
void expect_as_brute_force(const std::vector<Triangle>& triangles, const std::vector<Vec3>& points) {
  const TriangleTree tree(triangles);
  std::vector<Nearby> found;
  for (const Vec3& p : points) {
    const Nearby expected = nearest_of_all(triangles, p);
    const auto nearest = tree.nearest(p);
    ASSERT_TRUE(nearest);
    expect_equal(*nearest, expected);
    const double d = std::sqrt(expected.squared_distance);
    ASSERT_TRUE(tree.nearest(p, d * (1 + 1e-14) + 1e-300));
    expect_equal(*tree.nearest(p, 2 * d + 1), expected);
    EXPECT_FALSE(d > 0 && tree.nearest(p, d * (1 - 1e-12)));
    const double radius = 1.5 * d + 0.01;
    tree.within(p, radius, found);
    auto next = found.begin();
    for (Index f = 0; f < triangles.size(); ++f) {
      const auto q = closest_point(p, triangles[f]);
      if (q.squared_distance > radius * radius) continue;
      ASSERT_NE(next, found.end());
      expect_equal(*next++, {f, q.barycentric, q.squared_distance});
    }
    EXPECT_EQ(next, found.end());
  }
}

std::vector<Vec3> points(std::size_t n, unsigned seed, const Vec3& low, const Vec3& high) {
  Random random(seed);
  std::vector<Vec3> all(n);
  for (Vec3& p : all) p = random.point(low, high);
  return all;
}

TEST(ClosestPoint, IsNoFartherThanAnyPointOfADenseSampling) {
  Random random(1);
  for (int k = 0; k < 200; ++k) {
    const Triangle t = soup(1, static_cast<unsigned>(k), 1, {-1, -1, -1}, {1, 1, 1})[0];
    const Vec3 p = random.point({-2, -2, -2}, {2, 2, 2});
    const auto q = closest_point(p, t);
    const auto& w = q.barycentric;
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-15);
    EXPECT_GE(std::min({w[0], w[1], w[2]}), 0);
    const double d = std::sqrt(q.squared_distance);
    EXPECT_NEAR(distance(p, at(t, w)), d, 1e-14);
    double least = infinity;
    for (int i = 0; i <= 100; ++i)
      for (int j = 0; i + j <= 100; ++j)
        least = std::min(least, distance(p, at(t, {i / 100.0, j / 100.0, (100 - i - j) / 100.0})));
    EXPECT_LE(d, least + 1e-14);
    EXPECT_GT(d, least - 0.02);
  }
}

TEST(ClosestPoint, RegionsOfATriangle) {
  const Triangle t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_EQ(closest_point({0.25, 0.25, 2}, t).squared_distance, 4);
  EXPECT_EQ(closest_point({-1, -1, 0}, t).barycentric, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(closest_point({0.5, -3, 0}, t).squared_distance, 9);
  EXPECT_EQ(closest_point({1, 1, 0}, t).barycentric, (std::array<double, 3>{0, 0.5, 0.5}));
}

TEST(ClosestPoint, TrianglesWithoutAreaAreSegmentsOrPoints) {
  const Triangle segment{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}}}, point{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}};
  EXPECT_EQ(closest_point({0.5, 1, 0}, segment).squared_distance, 1);
  EXPECT_EQ(closest_point({3, 0, 0}, segment).squared_distance, 1);
  EXPECT_EQ(closest_point({1, 2, 5}, point).squared_distance, 4);
}

TEST(ClosestPoint, ANeedleFarFromTheOriginLosesNoDigits) {
  const Triangle needle{{{1e6, 0, 0}, {1e6 + 1, 1e-9, 0}, {1e6 + 2, 0, 0}}};
  EXPECT_NEAR(std::sqrt(closest_point({1e6 + 0.7, 0.5e-9, 0}, needle).squared_distance), 0, 1e-12);
  EXPECT_NEAR(std::sqrt(closest_point({1e6 + 0.7, 0, 1}, needle).squared_distance), 1, 1e-15);
}

TEST(TriangleTree, RandomTriangles) {
  expect_as_brute_force(soup(2000, 3, 0.1, {0, 0, 0}, {1, 1, 1}), points(500, 4, {-1, -1, -1}, {2, 2, 2}));
  expect_as_brute_force(soup(300, 5, 1, {0, 0, 0}, {1, 1, 1}), points(200, 6, {0, 0, 0}, {1, 1, 1}));
}

TEST(TriangleTree, PointsOnTheTrianglesAreFoundAtDistanceZero) {
  const auto triangles = soup(2000, 7, 0.05, {0, 0, 0}, {1, 1, 1});
  std::vector<Vec3> corners;
  for (const Triangle& t : triangles) corners.push_back(t[2]);
  expect_as_brute_force(triangles, corners);
}

TEST(TriangleTree, AFlatBox) {
  expect_as_brute_force(soup(2000, 8, 0.02, {0, 0, 0}, {1, 1, 0}), points(300, 9, {-1, -1, 0}, {2, 2, 0}));
  expect_as_brute_force(soup(500, 10, 0.02, {0, 3, 5}, {1, 3, 5}), points(100, 11, {-1, 2, 4}, {2, 4, 6}));
}

TEST(TriangleTree, TrianglesWithoutArea) {
  auto triangles = soup(600, 12, 0.1, {0, 0, 0}, {1, 1, 1});
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    Triangle& t = triangles[i];
    if (i % 3 == 0) t[1] = t[0];
    if (i % 3 == 1) t[1] = t[2] = t[0];
  }
  expect_as_brute_force(triangles, points(300, 13, {-1, -1, -1}, {2, 2, 2}));
}

TEST(TriangleTree, FarFromTheOriginAndSmall) {
  const Vec3 low{1e7, -1e7, 3e6}, high{1e7 + 1e-2, -1e7 + 1e-2, 3e6 + 1e-2};
  expect_as_brute_force(soup(1000, 14, 1e-3, low, high), points(200, 15, low, high));
}

TEST(TriangleTree, PointsFarAway) {
  const auto triangles = soup(1000, 16, 0.1, {0, 0, 0}, {1, 1, 1});
  for (const double far : {1e1, 1e3, 1e5, 1e7, 1e12})
    expect_as_brute_force(triangles, points(50, 17, {-far, -far, -far}, {far, far, far}));
}

TEST(TriangleTree, OneFarTriangleDoesNotHideTheOthers) {
  auto triangles = soup(1000, 18, 1e-6, {0, 0, 0}, {1e-5, 1e-5, 1e-5});
  triangles.push_back({{{1e4, 0, 0}, {1e4, 1, 0}, {1e4, 0, 1}}});
  expect_as_brute_force(triangles, points(100, 19, {0, 0, 0}, {1e-5, 1e-5, 1e-5}));
}

TEST(TriangleTree, TiesGoToTheLowestFacet) {
  const Triangle t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const TriangleTree tree(std::vector<Triangle>(100, t));
  EXPECT_EQ(tree.nearest({0.2, 0.2, 1})->facet, 0U);
  std::vector<Nearby> found;
  tree.within({0.2, 0.2, 1}, 1, found);
  EXPECT_EQ(found.size(), 100U) << "the radius is inclusive";
}

TEST(TriangleTree, NearestOfChosenPoints) {
  // Of every third triangle its first corner counts, of the others nothing.
  const auto triangles = soup(900, 22, 0.2, {0, 0, 0}, {1, 1, 1});
  const TriangleTree tree(triangles);
  for (const Vec3& p : points(100, 23, {-1, -1, -1}, {2, 2, 2})) {
    const auto choose = [&](Index f) -> std::optional<PointOnTriangle> {
      if (f % 3 != 0) return std::nullopt;
      const double d = distance(p, triangles[f][0]);
      return PointOnTriangle{{1, 0, 0}, d * d};
    };
    Nearby best{no_index, {}, infinity};
    for (Index f = 0; f < triangles.size(); ++f)
      if (const auto q = choose(f); q && q->squared_distance < best.squared_distance)
        best = {f, q->barycentric, q->squared_distance};
    const auto found = tree.nearest_chosen(p, choose);
    ASSERT_TRUE(found);
    expect_equal(*found, best);
  }
  EXPECT_FALSE(tree.nearest_chosen({0, 0, 0}, [](Index) { return std::nullopt; }));
}

TEST(TriangleTree, ABoundChangesNoAnswerWithinIt) {
  const auto triangles = soup(900, 24, 0.2, {0, 0, 0}, {1, 1, 1});
  const TriangleTree tree(triangles);
  for (const Vec3& p : points(100, 25, {-1, -1, -1}, {2, 2, 2})) {
    const auto choose = [&](Index f) -> std::optional<PointOnTriangle> {
      return f % 7 == 0 ? std::optional(closest_point(p, triangles[f])) : std::nullopt;
    };
    const auto best = tree.nearest_chosen(p, choose);
    ASSERT_TRUE(best);
    const double d = std::sqrt(best->squared_distance);
    const auto found = tree.nearest_chosen(p, choose, 1.001 * d + 1e-9);
    ASSERT_TRUE(found);
    expect_equal(*found, *best);
    if (d > 0) {
      EXPECT_FALSE(tree.nearest_chosen(p, choose, 0.999 * d));
    }
  }
}

TEST(TriangleTree, HasSomethingWithinADistanceWheneverTheNearestOneIs) {
  const auto triangles = soup(900, 26, 0.2, {0, 0, 0}, {1, 1, 1});
  const TriangleTree tree(triangles);
  for (const Vec3& p : points(100, 27, {-1, -1, -1}, {2, 2, 2})) {
    const double d = std::sqrt(tree.nearest(p)->squared_distance);
    EXPECT_TRUE(tree.has_within(p, 1.001 * d + 1e-9));
    if (d > 0) {
      EXPECT_FALSE(tree.has_within(p, 0.999 * d));
    }
  }
  EXPECT_FALSE(TriangleTree(std::vector<Triangle>{}).has_within({0, 0, 0}, 1));
}

TEST(TriangleTree, WithoutTrianglesNothingIsNear) {
  const TriangleTree tree(std::vector<Triangle>{});
  EXPECT_FALSE(tree.nearest({0, 0, 0}));
  std::vector<Nearby> found(1);
  tree.within({0, 0, 0}, 1, found);
  EXPECT_TRUE(found.empty());
}

TEST(TriangleTree, AllTrianglesInOnePoint) {
  const Triangle t{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}};
  const TriangleTree tree(std::vector{t});
  EXPECT_EQ(tree.nearest({1, 2, 5})->squared_distance, 4);
}

TEST(TriangleTree, RefusesWhatIsNotFinite) {
  Triangle t{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const TriangleTree tree(std::vector{t});
  EXPECT_THROW((void)tree.nearest({infinity, 0, 0}), UsageError);
  t[2][1] = std::nan("");
  EXPECT_THROW(TriangleTree(std::vector{t}), InputError);
}

TEST(TriangleTree, AnswersManyThreads) {
  const auto triangles = soup(3000, 20, 0.1, {0, 0, 0}, {1, 1, 1});
  const auto asked = points(2000, 21, {0, 0, 0}, {1, 1, 1});
  const TriangleTree tree(triangles);
  std::vector<std::vector<Nearby>> answers(4, std::vector<Nearby>(asked.size()));
  std::vector<std::thread> threads;
  for (auto& answer : answers)
    threads.emplace_back([&] {
      for (std::size_t i = 0; i < asked.size(); ++i) answer[i] = *tree.nearest(asked[i]);
    });
  for (auto& t : threads) t.join();
  for (std::size_t i = 0; i < asked.size(); ++i)
    for (const auto& answer : answers) expect_equal(answer[i], answers[0][i]);
}

/// A fine soup with some triangles far away, once and at several distances, where the tree changes its
/// method.
std::vector<Triangle> with_far_ones(std::size_t n, double distance, double step) {
  std::vector<Triangle> all = soup(n, 5, 0.05, {-1, -1, -1}, {1, 1, 1});
  for (double d = distance; d < 1e30; d *= step) all.push_back({{{d, 0, 0}, {d, d / 10, 0}, {d, 0, 1}}});
  return all;
}

TEST(TriangleTree, AgreesWithBruteForceWhateverTheExtent) {
  for (const std::size_t n : {300U, 3000U})
    for (const double distance : {1e2, 1e4, 1e6, 1e12})
      for (const double step : {1e2, 1e30}) {
        const auto all = with_far_ones(n, distance, step);
        std::vector<Vec3> asked = points(20, 6, {-1, -1, -1}, {1, 1, 1});
        for (const double d : {10.0, distance / 2, distance, 3 * distance})
          asked.push_back({d, d / 100, 0.3});
        expect_as_brute_force(all, asked);
        expect_as_brute_force(soup(n, 7, 0.05, {-1, -1, -1}, {1, 1, 1}), asked);
      }
}

/// CPU seconds of some queries, the best of three.
double time_of(const TriangleTree& tree, const std::vector<Vec3>& asked) {
  double best = infinity;
  for (int k = 0; k < 3; ++k) {
    const std::clock_t begin = std::clock();
    for (const Vec3& p : asked) EXPECT_TRUE(tree.nearest(p));
    best = std::min(best, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  }
  return best;
}

TEST(TriangleTree, ItsTimeDoesNotDependOnTheExtent) {
  const std::vector<Vec3> near = points(2000, 8, {-1, -1, -1}, {1, 1, 1});
  std::vector<Vec3> far = near;
  for (Vec3& p : far) p[0] += 1e7;
  const TriangleTree alone(soup(50'000, 5, 0.01, {-1, -1, -1}, {1, 1, 1}));
  const double normal = time_of(alone, near) + 1e-4;
  EXPECT_LT(time_of(alone, far), 20 * normal);
  for (const double distance : {1e3, 1e6, 1e9, 1e20}) {
    std::vector<Triangle> all = alone.triangles();
    all.push_back({{{distance, 0, 0}, {distance, 1, 0}, {distance, 0, 1}}});
    EXPECT_LT(time_of(TriangleTree(all), near), 20 * normal) << distance;  // all, one by one: 500 times
  }
}

}  // namespace
}  // namespace multimesh::spatial
