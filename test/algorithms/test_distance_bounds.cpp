// SPDX-License-Identifier: BSD-3-Clause
// DecimateOptions::max_error: judged by brute force, without any code of the placement test that enforces it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "multimesh/geometry/closest_point.hpp"
#include "multimesh/geometry/near_triangles.hpp"
#include "multimesh/geometry/witnesses.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/decimate_cost_name.hpp"
#include "test/algorithms/made_surface.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

using spatial::Triangle;

Vec3 point(const Vec3& p) {
  return {p[0], p[1], p[2]};
}

std::vector<Triangle> in_space(const TexturedTriangles& s) {
  std::vector<Triangle> triangles;
  for (const auto& t : s.triangles) {
    triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i)
      triangles.back()[i] = point(s.positions[static_cast<std::size_t>(t[i].position)]);
  }
  return triangles;
}

/// Of the triangles, those within a distance of the box of t, and perhaps some others.
std::vector<Triangle> around(const Triangle& t, const std::vector<Triangle>& triangles, double distance) {
  std::vector<Triangle> found;
  for (const Triangle& u : triangles) {
    bool apart = false;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({t[0][i], t[1][i], t[2][i]});
      const auto [u_low, u_high] = std::minmax({u[0][i], u[1][i], u[2][i]});
      apart |= u_low > high + distance || u_high < low - distance;
    }
    if (!apart) found.push_back(u);
  }
  return found;
}

bool is_near(const Vec3& p, const std::vector<Triangle>& triangles, double distance) {
  return std::any_of(triangles.begin(), triangles.end(), [&](const Triangle& t) {
    return spatial::closest_point(p, t).squared_distance <= distance * distance;
  });
}

/// Points of a grid over all triangles of `from`, corners included, that are farther than a distance from
/// every triangle of `to`.
std::size_t far_points(const TexturedTriangles& from, const TexturedTriangles& to, double distance,
                       int per_edge = 10) {
  const std::vector<Triangle> all = in_space(to);
  std::size_t far = 0;
  for (const Triangle& t : in_space(from)) {
    const std::vector<Triangle> candidates = around(t, all, distance);
    for (int i = 0; i <= per_edge; ++i)
      for (int j = 0; i + j <= per_edge; ++j) {
        const double u = 1.0 * i / per_edge, v = 1.0 * j / per_edge;
        far += !is_near(spatial::at(t, {1 - u - v, u, v}), candidates, distance);
      }
  }
  return far;
}

std::size_t far_vertices(const TexturedTriangles& from, const TexturedTriangles& to, double distance) {
  return far_points(from, to, distance, 1);
}

constexpr double rounding = 1 + 1e-9;

/// Expects what max_error guarantees.
void expect_within(double error, const TexturedTriangles& input, const TexturedTriangles& result) {
  const double distance = error * bounding_box_diagonal(input.positions) * rounding;
  EXPECT_EQ(far_points(input, result, distance), 0U) << "points of the input, error " << error;
  EXPECT_EQ(far_vertices(result, input, distance), 0U) << "vertices of the result, error " << error;
}

TexturedTriangles triangles_of(const TexturedSurface& surface) {
  std::vector<Index> source;
  return surface.triangles(source);
}

DecimateOptions to_error(double error, DecimateCost cost) {
  DecimateOptions o;
  o.max_error = error;
  o.cost = cost;
  return o;
}

/// Moves each vertex at random, by at most this much in each direction.
TexturedTriangles rough(TexturedTriangles s, double noise) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> offset(-noise, noise);
  for (Vec3& p : s.positions)
    for (std::size_t i = 0; i < 3; ++i) p[i] += offset(random);
  return s;
}

Shape bent_sheet() {
  Shape s = grid(30, 30);
  for (Point& p : s.points) p[2] = 2 * std::sin(p[0] / 4) * std::cos(p[1] / 5);
  return s;
}

/// Spheres in a row, each inside of the next one's reach, and a sheet.
TexturedTriangles several_components() {
  TexturedTriangles s = bare(bent_sheet());
  for (int i = 0; i < 3; ++i) {
    const TexturedTriangles ball = bare(sphere(3));
    const auto first = static_cast<std::int32_t>(s.positions.size());
    for (const Vec3& p : ball.positions) s.positions.push_back(p * 3.0 + Vec3(6.1 * i, 5, 5));
    for (auto t : ball.triangles) {
      for (auto& c : t) c.position += first;
      s.triangles.push_back(t);
    }
  }
  return s;
}

/// Large triangles and small ones side by side, needles between them.
TexturedTriangles uneven() {
  Shape s = grid(30, 30);
  for (Point& p : s.points) {
    p[0] = std::pow(p[0] / 30, 4) * 30;
    p[2] = 2 * std::cos(p[0] / 3) + std::sin(p[1] / 3);
  }
  return bare(s);
}

/// Some triangles have no area: their corners coincide or lie on a line.
TexturedTriangles partly_degenerate() {
  TexturedTriangles s = bare(bent_sheet());
  for (std::size_t v = 100; v < 900; v += 50) s.positions[v] = s.positions[v + 1];
  for (std::size_t v = 120; v < 900; v += 50)
    s.positions[v] = (s.positions[v - 1] + s.positions[v + 1]) / 2.0;
  return s;
}

/// A fan around a vertex whose star is larger than what the placement test examines.
TexturedTriangles cone() {
  Shape s = disk(300);
  for (Point& p : s.points) p[2] = 0.1 * std::cos(20 * std::atan2(p[1], p[0]));
  return bare(s);
}

struct Named {
  std::string name;
  TexturedTriangles input;
};

std::vector<Named> surfaces() {
  std::vector<Named> list{
      {"BentSheet", bare(bent_sheet())},           {"RoughTorus", rough(bare(torus(20, 12)), 0.05)},
      {"SeveralComponents", several_components()}, {"Uneven", uneven()},
      {"PartlyDegenerate", partly_degenerate()},   {"Cone", cone()}};
  for (const MadeSurface& made : made_surfaces()) {
    const double diagonal = bounding_box_diagonal(made.input.positions);
    list.push_back({"Rough" + made.name, rough(made.input, 0.005 * diagonal)});
  }
  return list;
}

class MaximalError : public ::testing::TestWithParam<DecimateCost> {};

TEST_P(MaximalError, HoldsForAllPointsOfTheInputAndAllVerticesOfTheResult) {
  for (const Named& s : surfaces()) {
    SCOPED_TRACE(s.name);
    for (const double error : {2e-3, 1e-2, 5e-2}) {
      TexturedSurface surface(s.input);
      const DecimateResult r = decimate(surface, to_error(error, GetParam()));
      if (error > 1e-2) {
        EXPECT_LT(r.faces_after, r.faces_before / 2) << "and something was done";
      }
      expect_within(error, s.input, triangles_of(surface));
    }
  }
}

TEST_P(MaximalError, HoldsForSpot) {
  std::size_t left = spot().triangles.size();
  for (const double error : {5e-4, 2e-3, 1e-2}) {
    TexturedSurface surface(spot());
    const DecimateResult r = decimate(surface, to_error(error, GetParam()));
    EXPECT_LT(r.faces_after, left) << "more error, fewer faces";
    left = r.faces_after;
    EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
    expect_within(error, spot(), triangles_of(surface));
  }
}

TEST_P(MaximalError, IsAgainstTheInputOnAllLevelsOfOneRun) {
  const TexturedTriangles input = bare(bent_sheet());
  TexturedSurface surface(input);
  const double error = 5e-3;
  DecimateOptions o = to_error(error, GetParam());
  o.levels = {1200, 600, 300};
  std::size_t levels = 0;
  o.on_level = [&](std::size_t) {
    ++levels;
    expect_within(error, input, triangles_of(surface));
  };
  decimate(surface, o);
  EXPECT_GE(levels, 2U);
  expect_within(error, input, triangles_of(surface));
}

TEST_P(MaximalError, IsAgainstTheSurfaceOfTheCallInTwoRuns) {
  const TexturedTriangles input = bare(bent_sheet());
  TexturedSurface surface(input);
  const double error = 3e-3, diagonal = bounding_box_diagonal(input.positions);
  decimate(surface, to_error(error, GetParam()));
  const TexturedTriangles between = triangles_of(surface);
  decimate(surface, to_error(error, GetParam()));
  const TexturedTriangles result = triangles_of(surface);
  EXPECT_LT(result.triangles.size(), between.triangles.size());
  expect_within(error, between, result);
  EXPECT_EQ(far_points(input, result, 2 * error * diagonal * rounding), 0U) << "the sum of both bounds it";
}

TEST_P(MaximalError, ThatAllowsNothingLeavesAllAsItWas) {
  const TexturedTriangles input = rough(bare(grid(12, 12)), 0.2);
  TexturedSurface surface(input);
  const TexturedTriangles before = triangles_of(surface);
  const DecimateResult r = decimate(surface, to_error(1e-9, GetParam()));
  EXPECT_EQ(r.stop, DecimateResult::Stop::bound);
  EXPECT_EQ(r.collapsed, 0U);
  ASSERT_FALSE(r.refused.empty());
  EXPECT_EQ(r.refused.front().reason, "maximal error");
  EXPECT_EQ(triangles_of(surface).positions, before.positions);
  EXPECT_EQ(triangles_of(surface).triangles.size(), before.triangles.size());
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
}

TEST_P(MaximalError, OfZeroKeepsToPlanes) {
  TexturedSurface surface(bare(grid(16, 16)));
  const DecimateResult r = decimate(surface, to_error(0, GetParam()));
  EXPECT_GT(r.collapsed, 0U) << "the coordinates of the grid are exact";
  expect_within(1e-15, bare(grid(16, 16)), triangles_of(surface));
}

INSTANTIATE_TEST_SUITE_P(Cost, MaximalError, ::testing::Values(DecimateCost::quadric, DecimateCost::length),
                         [](const auto& p) { return name_of(p.param); });

TEST(Witnesses, ListsAgreeWithSetsAfterManyChanges) {
  using spatial::Witnesses;
  constexpr Index n = 12;
  Witnesses witnesses(n);
  Witnesses::Set set;
  set.fill(no_index);
  std::vector<Witnesses::Set> sets(n, set);
  std::mt19937 random(3);
  std::uniform_int_distribution<Index> any(0, n - 1), coin(0, 1);
  for (int step = 0; step < 1000; ++step) {
    const Index input = any(random), w = any(random);
    for (Index i = 0; i < set.size(); ++i) set[i] = coin(random) ? (w + i) % n : no_index;
    witnesses.set(input, set);
    sets[input] = set;
    for (Index t = 0; t < n; ++t) {
      std::vector<Index> listed, expected;
      witnesses.all_of(t, [&](Index i) { return listed.push_back(i), true; });
      for (Index i = 0; i < n; ++i)
        if (std::find(sets[i].begin(), sets[i].end(), t) != sets[i].end()) expected.push_back(i);
      std::sort(listed.begin(), listed.end());
      ASSERT_EQ(listed, expected);
      ASSERT_EQ(witnesses.of(t), sets[t]);
    }
  }
}

TEST(NearTriangles, AgreeWithTheClosestPoints) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> number(0, 2);
  const auto place = [&] { return Vec3{number(random), number(random), number(random)}; };
  const double distance = 0.3;
  spatial::NearTriangles near(distance);
  std::vector<Triangle> triangles;
  for (Index i = 0; i < spatial::NearTriangles::capacity; ++i) {
    triangles.push_back({place(), place(), place()});
    near.add(i, triangles.back());
  }
  for (int k = 0; k < 1000; ++k) {
    const Vec3 p = place();
    const auto mask = near.near(p).mask, late = near.near(p, 10).mask;
    EXPECT_EQ(mask >> 10, late >> 10);
    EXPECT_EQ(late & 1023U, 0U);
    for (std::size_t i = 0; i < triangles.size(); ++i)
      EXPECT_EQ(mask >> i & 1, is_near(p, {triangles[i]}, distance));
  }
}

}  // namespace
}  // namespace multimesh::test
