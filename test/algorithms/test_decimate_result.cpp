// SPDX-License-Identifier: BSD-3-Clause
// The options of decimate() and its report on a run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "multimesh/geometry/closest_point.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

DecimateOptions to_faces(std::size_t faces) {
  DecimateOptions o;
  o.faces = faces;
  return o;
}

DecimateOptions to_error(double error, DecimateCost cost = DecimateCost::quadric) {
  DecimateOptions o;
  o.max_error = error;
  o.cost = cost;
  return o;
}

std::size_t sum(const std::vector<RefusalCount>& list) {
  return std::accumulate(list.begin(), list.end(), std::size_t{0},
                         [](std::size_t n, const RefusalCount& r) { return n + r.count; });
}

bool most_frequent_first(const std::vector<RefusalCount>& list) {
  return std::is_sorted(list.begin(), list.end(),
                        [](const auto& x, const auto& y) { return x.count > y.count; });
}

TEST(DecimateOptions, NoTargetIsRefused) {
  TexturedSurface surface(one_chart().input);
  EXPECT_THROW(decimate(surface, {}), InputError);
  EXPECT_THROW(decimate(surface, to_error(std::nan(""))), InputError);
  EXPECT_EQ(surface.live_triangles(), surface.tree().mesh(NodeId::root).capacity(2))
      << "and nothing was done";
}

TEST(DecimateOptions, AsManyFacesAsThereAreChangesNothing) {
  for (const MadeSurface& made : made_surfaces()) {
    TexturedSurface surface(made.input);
    std::vector<Index> source_before, source_after;
    const TexturedTriangles before = surface.triangles(source_before);
    for (const std::size_t more : {0, 1, 1000}) {
      const DecimateResult r = decimate(surface, to_faces(before.triangles.size() + more));
      EXPECT_EQ(r.stop, DecimateResult::Stop::faces);
      EXPECT_EQ(r.collapsed, 0U);
    }
    const TexturedTriangles after = surface.triangles(source_after);
    EXPECT_EQ(after.positions, before.positions) << made.name;
    EXPECT_EQ(after.texcoords, before.texcoords) << made.name;
    EXPECT_EQ(source_after, source_before) << made.name;
  }
}

/// Of the vertices of `from`, the largest distance to the triangles of `to`, relative to the diagonal.
double farthest_vertex(const TexturedTriangles& from, const TexturedTriangles& to) {
  const auto point = [](const Vec3& p) { return Vec3{p[0], p[1], p[2]}; };
  double farthest = 0;
  for (const auto& v : from.positions) {
    double nearest = infinity;
    for (const auto& t : to.triangles) {
      spatial::Triangle triangle;
      for (std::size_t i = 0; i < 3; ++i)
        triangle[i] = point(to.positions[static_cast<std::size_t>(t[i].position)]);
      nearest = std::min(nearest, spatial::closest_point(point(v), triangle).squared_distance);
    }
    farthest = std::max(farthest, nearest);
  }
  return std::sqrt(farthest) / bounding_box_diagonal(from.positions);
}

TEST(DecimateOptions, MaximalErrorBoundsTheDistanceOfInputVertices) {
  const MadeSurface made = sphere_with_charts();
  std::size_t left = std::numeric_limits<std::size_t>::max();
  for (const DecimateCost cost : {DecimateCost::length, DecimateCost::quadric})
    for (const double error : {1e-3, 1e-2, 5e-2}) {
      TexturedSurface surface(made.input);
      const DecimateResult r = decimate(surface, to_error(error, cost));
      EXPECT_EQ(r.stop, DecimateResult::Stop::bound);
      if (error == 1e-3) left = std::numeric_limits<std::size_t>::max();
      EXPECT_LT(r.faces_after, left) << "more error, fewer faces";
      left = r.faces_after;
      std::vector<Index> source;
      const double reached = farthest_vertex(made.input, surface.triangles(source));
      EXPECT_LE(reached, error * (1 + 1e-9));
      EXPECT_GT(reached, error / 4) << "and makes use of what is allowed";
    }
}

TEST(DecimateOptions, ErrorsAreRelativeToTheBoundingBox) {
  MadeSurface made = sphere_with_charts();
  TexturedSurface small(made.input);
  for (auto& p : made.input.positions) p *= 1024;
  TexturedSurface large(made.input);
  const DecimateResult s = decimate(small, to_error(1e-3)), l = decimate(large, to_error(1e-3));
  EXPECT_EQ(s.faces_after, l.faces_after);
  EXPECT_NEAR(s.max_cost, l.max_cost, 1e-9);
}

TEST(DecimateOptions, OfTwoTargetsTheFirstThatIsMetStops) {
  DecimateOptions o = to_faces(10);
  o.max_error = 1e-4;
  TexturedSurface surface(sphere_with_charts().input);
  EXPECT_EQ(decimate(surface, o).stop, DecimateResult::Stop::bound);
  o = to_faces(2000);
  o.max_error = 1;
  TexturedSurface other(sphere_with_charts().input);
  const DecimateResult r = decimate(other, o);
  EXPECT_EQ(r.stop, DecimateResult::Stop::faces);
  EXPECT_GE(r.faces_after, 1999U);
}

TEST(DecimateOptions, FlatPartsCostNothing) {
  TexturedSurface surface(one_chart().input);
  const DecimateResult r = decimate(surface, to_error(1e-7));
  EXPECT_LT(r.faces_after, r.faces_before / 4) << "the inside of a planar grid has no error";
}

TEST(DecimateResult, AnExhaustedRunNamesWhatKeepsEveryEdge) {
  TexturedSurface surface(octahedron().input);
  const DecimateResult r = decimate(surface, to_faces(1));
  ASSERT_EQ(r.stop, DecimateResult::Stop::exhausted);
  EXPECT_EQ(r.faces_after, 8U) << "the octahedron itself: its corners are junctions";
  EXPECT_EQ(sum(r.blocking), 12U);
  EXPECT_TRUE(most_frequent_first(r.blocking));
  EXPECT_TRUE(most_frequent_first(r.refused));
}

TEST(DecimateResult, TriedIsDoneAndRefused) {
  for (const std::size_t faces : {1, 100, 1000}) {
    TexturedSurface surface(sphere_with_charts().input);
    const DecimateResult r = decimate(surface, to_faces(faces));
    EXPECT_EQ(r.tried, r.collapsed + sum(r.refused)) << "down to " << faces;
  }
}

TEST(DecimateResult, ASecondRunGoesOnFromTheFirst) {
  const MadeSurface made = sphere_with_charts();
  TexturedSurface surface(made.input);
  const DecimateResult first = decimate(surface, to_faces(1000));
  const DecimateResult second = decimate(surface, to_faces(100));
  EXPECT_EQ(second.faces_before, first.faces_after);
  EXPECT_LE(second.faces_after, 100U);
  std::vector<Index> source;
  const TexturedTriangles after = surface.triangles(source);
  EXPECT_EQ(facts(after), facts(made.input));
  EXPECT_EQ(newly_flipped(made.input, after, source), 0U);
}

TEST(DecimateResult, OneTriangleStays) {
  TexturedTriangles in;
  in.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  in.texcoords = {{0, 0}, {1, 0}, {0, 1}};
  in.triangles = {{{{0, 0}, {1, 1}, {2, 2}}}};
  TexturedSurface surface(in);
  const DecimateResult r = decimate(surface, to_error(1e9));
  EXPECT_EQ(r.stop, DecimateResult::Stop::exhausted);
  EXPECT_EQ(r.faces_after, 1U);
  EXPECT_EQ(sum(r.blocking), 3U);
}

class Progress : public ::testing::Test {
 protected:
  TexturedSurface surface{bare(sphere(6))};  // 32768 triangles
};

TEST_F(Progress, CountsDownToTheTarget) {
  std::vector<std::size_t> seen;
  DecimateOptions o = to_faces(1000);
  o.progress = [&](std::size_t faces) { seen.push_back(faces); };
  const DecimateResult r = decimate(surface, o);
  EXPECT_GE(seen.size(), r.collapsed / 2048);
  EXPECT_TRUE(std::is_sorted(seen.rbegin(), seen.rend()));
  ASSERT_FALSE(seen.empty());
  EXPECT_LT(seen.front(), r.faces_before);
  EXPECT_GE(seen.back(), r.faces_after);
}

TEST_F(Progress, AnExceptionAbandonsTheRunAndLeavesAValidTree) {
  DecimateOptions o = to_faces(1000);
  std::size_t last = 0;
  o.progress = [&](std::size_t faces) {
    last = faces;
    if (faces < 20000) throw std::runtime_error("enough");
  };
  EXPECT_THROW(decimate(surface, o), std::runtime_error);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  EXPECT_EQ(surface.live_triangles(), last);
  EXPECT_EQ(report(surface.tree().mesh(NodeId::root)).euler_characteristic, 2);
  const DecimateResult r = decimate(surface, to_faces(1000));
  EXPECT_EQ(r.stop, DecimateResult::Stop::faces) << "and the run can be taken up again";
}

}  // namespace
}  // namespace multimesh::test
