// SPDX-License-Identifier: BSD-3-Clause
// Long thin triangles, as CAD programs write: the length is reached, with no more work than the result needs.
#include <gtest/gtest.h>

#include <cmath>
#include <ctime>
#include <map>
#include <numbers>
#include <numeric>

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "test/remesh/needles.hpp"

namespace multimesh::test {
namespace {

/// Counted from the triangles alone.
struct Counted {
  std::size_t faces = 0, edges = 0, in_range = 0, not_two_faces = 0;
  std::size_t with_small_angle = 0;  ///< below 25 degrees
  long euler = 0;
  double area = 0;
};

bool has_small_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = (b - a).normalized(), v = (c - b).normalized(), w = (a - c).normalized();
  return std::max({-dot(u, w), -dot(v, u), -dot(w, v)}) > std::cos(25 * std::numbers::pi / 180);
}

Counted count(const TexturedTriangles& s, double length) {
  std::map<std::pair<int, int>, int> edges;
  std::map<int, int> vertices;
  Counted c;
  const auto at = [&](int v) { return s.positions[static_cast<std::size_t>(v)]; };
  for (const auto& t : s.triangles) {
    ++c.faces;
    c.area += cross(at(t[1].position) - at(t[0].position), at(t[2].position) - at(t[0].position)).norm() / 2;
    c.with_small_angle += has_small_angle(at(t[0].position), at(t[1].position), at(t[2].position));
    for (std::size_t i = 0; i < 3; ++i) {
      ++vertices[t[i].position];
      ++edges[std::minmax(t[i].position, t[(i + 1) % 3].position)];
    }
  }
  c.edges = edges.size();
  for (const auto& [e, faces] : edges) {
    const double l = (at(e.first) - at(e.second)).norm();
    c.in_range += l >= 0.8 * length && l <= 4.0 / 3 * length;
    c.not_two_faces += faces != 2;
  }
  c.euler = long(vertices.size()) - long(c.edges) + long(c.faces);
  return c;
}

/// `angle`: degrees; 0: no sharp curves.
void expect_even(const TexturedTriangles& in, double relative, double angle) {
  SCOPED_TRACE("length " + std::to_string(relative) + ", angle " + std::to_string(angle));
  TexturedSurfaceOptions curves;
  if (angle > 0) curves.feature_angle = angle * std::numbers::pi / 180;
  TexturedSurface surface(in, curves);
  RemeshOptions options;
  options.length = relative * bounding_box_diagonal(in.positions);
  const RemeshResult r = remesh(surface, options);
  std::vector<Index> source;
  const Counted before = count(in, options.length), after = count(surface.triangles(source), options.length);
  EXPECT_GE(double(after.in_range), 0.9 * double(after.edges));
  EXPECT_LE(double(after.with_small_angle), 0.001 * double(after.faces));
  const double right = after.area / (std::sqrt(3) / 4 * options.length * options.length);
  EXPECT_LE(double(after.faces), 1.3 * right);
  EXPECT_GE(double(after.faces), 0.7 * right);
  EXPECT_NEAR(after.area, before.area, 0.1 * before.area);
  EXPECT_EQ(after.euler, before.euler);
  if (before.not_two_faces == 0) {
    EXPECT_EQ(after.not_two_faces, 0U);
  }
  // No operation reverses another one.
  EXPECT_LE(r.splits + r.collapses, 4 * (before.faces + after.faces));
}

class Needles : public testing::TestWithParam<std::tuple<int, Cap>> {
 protected:
  int segments = std::get<0>(GetParam());
  Cap cap = std::get<1>(GetParam());
};

TEST_P(Needles, BecomeEvenOnACylinder) {
  for (const double length : {0.1, 0.05, 0.03})
    for (const double angle : {0.0, 40.0}) expect_even(cylinder(segments, 2, 1, cap), length, angle);
}

TEST_P(Needles, BecomeEvenOnATaperedPipe) {
  expect_even(cylinder(segments, 6, 0.4, cap), 0.03, 40);
}

TEST_P(Needles, BecomeEvenOnACone) {
  for (const double length : {0.06, 0.03}) expect_even(cone(segments, 2, cap), length, 40);
}

TEST_P(Needles, BecomeEvenOnADisk) {
  for (const double length : {0.05, 0.02}) expect_even(disk(segments, cap), length, 0);
}

INSTANTIATE_TEST_SUITE_P(Shapes, Needles,
                         testing::Combine(testing::Values(16, 64, 256, 2000), testing::ValuesIn(all_caps)),
                         [](const auto& info) {
                           return name(std::get<1>(info.param)) + std::to_string(std::get<0>(info.param));
                         });

TEST(NeedlesOnAPlate, BecomeEven) {
  for (const int segments : {64, 500, 2000})
    for (const double length : {0.05, 0.02})
      for (const double angle : {0.0, 40.0}) expect_even(plate(segments, 0.25), length, angle);
}

// Edges that are never split, long ones at the sides and short ones at the hole: triangles beside them do not
// get flatter with each round, and the run ends.
TEST(LockedBoundary, MakesNoEndlessWork) {
  for (const int segments : {24, 100, 1000}) {
    SCOPED_TRACE(segments);
    const TexturedTriangles in = drilled_plate(segments, 0, 0, 0.5, 0);
    TexturedSurface surface(in);
    RemeshOptions options;
    options.length = 0.02 * bounding_box_diagonal(in.positions);
    options.lock_boundary = true;
    const RemeshResult r = remesh(surface, options);
    std::vector<Index> source;
    const Counted after = count(surface.triangles(source), options.length);
    const double right = after.area / (std::sqrt(3) / 4 * options.length * options.length);
    EXPECT_LE(double(after.faces), 1.3 * right + 2 * segments);
    EXPECT_LE(r.splits + r.collapses, 8 * (in.triangles.size() + after.faces));
  }
}

class LargeStars : public testing::TestWithParam<int> {};

TEST_P(LargeStars, BecomeEvenOnADrilledPlate) {
  for (const double length : {0.05, 0.02})
    for (const double angle : {0.0, 40.0}) {
      expect_even(drilled_plate(GetParam(), 0, 0, 0.5, 0), length, angle);
      expect_even(drilled_plate(GetParam(), 0.3, -0.2, 0.4, 0), length, angle);
    }
  expect_even(drilled_plate(GetParam(), 0.1, 0.2, 0.6, 0.4), 0.03, 40);
}

TEST_P(LargeStars, BecomeEvenOnADiskWithItsMiddleAside) {
  for (const double length : {0.05, 0.02}) expect_even(eccentric_disk(GetParam(), 0.4, 0.3), length, 0);
}

TEST_P(LargeStars, BecomeEvenOnALens) {
  expect_even(lens(GetParam()), 0.03, 40);
}

INSTANTIATE_TEST_SUITE_P(Shapes, LargeStars, testing::Values(16, 50, 256, 2000, 4000));

/// Seconds of the processor, with everything around the operations, per operation.
double time_per_operation(const TexturedTriangles& in) {
  const std::clock_t begin = std::clock();
  TexturedSurface surface(in, {.feature_angle = 40 * std::numbers::pi / 180});
  RemeshOptions options;
  options.length = 0.02 * bounding_box_diagonal(in.positions);
  const RemeshResult r = remesh(surface, options);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return seconds / static_cast<double>(r.splits + r.collapses + r.swaps + r.moves);
}

// Small patches beside thousands of needles: their closest points are found without visiting the needles.
TEST(TimePerOperation, DoesNotDependOnLargeStars) {
  const double few = time_per_operation(drilled_plate(24, 0.1, 0.2, 0.5, 0.4));
  const double many = time_per_operation(drilled_plate(2000, 0.1, 0.2, 0.5, 0.4));
  EXPECT_LT(many, 10 * few);
}

}  // namespace
}  // namespace multimesh::test
