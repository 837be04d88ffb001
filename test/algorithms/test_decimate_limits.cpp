// SPDX-License-Identifier: BSD-3-Clause
// Bounds on normals and shapes, levels of detail, weights, and options that are refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/decimation/shape_tests.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/collapse_driver.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

constexpr double degrees = std::numbers::pi / 180;
constexpr double infinity = std::numeric_limits<double>::infinity();

DecimateOptions to_faces(std::size_t faces) {
  DecimateOptions o;
  o.faces = faces;
  return o;
}

struct Left {
  TexturedTriangles surface;
  std::vector<Index> source;
  DecimateResult result;
};

Left decimated(const TexturedTriangles& input, const DecimateOptions& options) {
  TexturedSurface surface(input);
  Left left;
  left.result = decimate(surface, options);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  left.surface = surface.triangles(left.source);
  return left;
}

const Vec3& position(const TexturedTriangles& s, std::size_t t, std::size_t i) {
  return s.positions[static_cast<std::size_t>(s.triangles[t][i].position)];
}
Vec3 area_vector(const TexturedTriangles& s, std::size_t t) {
  const Vec3& p = position(s, t, 0);
  return cross(position(s, t, 1) - p, position(s, t, 2) - p);
}
double angle(const Vec3& m, const Vec3& n) {
  return std::atan2(cross(m, n).norm(), dot(m, n));
}

/// The largest angle between the normals of an output triangle and of the input triangle that it was.
double deviation_from_source(const TexturedTriangles& in, const Left& out) {
  double most = 0;
  for (std::size_t t = 0; t < out.source.size(); ++t)
    most = std::max(most, angle(area_vector(out.surface, t), area_vector(in, out.source[t])));
  return most;
}

/// On a sphere around the origin: the largest angle between a triangle and the sphere, at the corners.
double deviation_from_sphere(const TexturedTriangles& s) {
  double most = 0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) most = std::max(most, angle(area_vector(s, t), position(s, t, i)));
  return most;
}

TEST(NormalDeviation, BoundsTheNormalsOfASphere) {
  const TexturedTriangles in = sphere_with_charts().input;
  const double before = deviation_from_sphere(in);
  std::size_t last = in.triangles.size();
  for (const double limit : {6.0, 12.0, 25.0}) {
    DecimateOptions options = to_faces(1);
    options.max_normal_deviation = limit * degrees;
    const Left left = decimated(in, options);
    EXPECT_EQ(left.result.stop, DecimateResult::Stop::bound);
    EXPECT_LT(left.result.faces_after, last) << "more deviation, fewer faces";
    last = left.result.faces_after;
    const double found = deviation_from_source(in, left);
    EXPECT_LE(found, limit * degrees * (1 + 1e-9));
    EXPECT_GT(found, limit * degrees / 4) << "and makes use of what is allowed";
    // A corner lies on triangles of the input that became part of this one, or beside them.
    EXPECT_LE(deviation_from_sphere(left.surface), limit * degrees + 2 * before);
  }
}

TEST(NormalDeviation, WithoutALimitItIsLarger) {
  const TexturedTriangles in = waves(3);
  EXPECT_GT(deviation_from_source(in, decimated(in, to_faces(60))), 20 * degrees);
  DecimateOptions options = to_faces(60);
  options.max_normal_deviation = 20 * degrees;
  EXPECT_LE(deviation_from_source(in, decimated(in, options)), 20 * degrees * (1 + 1e-9));
}

/// All input triangles that were merged into each one, by the rule that a dead triangle goes to those that
/// share its apex, against the cones that stand for them.
TEST(NormalDeviation, HoldsForAllTrianglesThatWereMergedIntoOne) {
  for (const double limit : {0.2, 0.6}) {
    TexturedTriangles in = sphere_with_charts().input;
    jitter(in, 0.1, 2);
    TexturedSurface surface(in);
    std::vector<Index> source;
    const TexturedTriangles start = surface.triangles(source);
    CollapseDriver driver(surface, {});
    decimation::NormalDeviation test(driver.reader(), limit);
    driver.add(test);
    std::vector<std::set<Index>> merged(start.triangles.size());
    for (Index f = 0; f < merged.size(); ++f) merged[f].insert(f);
    driver.on_collapse = [&](const decimation::PredictedStar& star) {
      for (const auto& dead : star.faces()) {
        if (!dead.dies) continue;
        const Index apex = dead.before.vertices[2];
        for (const auto& f : star.faces())
          if (!f.dies && (f.before.vertices[1] == apex || f.before.vertices[2] == apex))
            merged[f.before.facet].insert(merged[dead.before.facet].begin(), merged[dead.before.facet].end());
      }
    };
    std::mt19937 random(3);
    EXPECT_GT(driver.collapse_some(700, random), 100U);
    std::vector<Vec3> normals;
    for (std::size_t t = 0; t < start.triangles.size(); ++t) normals.push_back(area_vector(start, t));
    const TexturedTriangles left = surface.triangles(source);
    double most = 0;
    std::size_t largest = 0;
    const Mesh& root = surface.tree().mesh(NodeId::root);
    for (Index f = 0, t = 0; f < root.capacity(2); ++f) {
      if (!root.is_live(2, f)) continue;
      for (const Index m : merged[f]) most = std::max(most, angle(area_vector(left, t), normals[m]));
      largest = std::max(largest, merged[f].size());
      ++t;
    }
    EXPECT_LE(most, limit * (1 + 1e-9));
    EXPECT_GT(most, limit / 2);
    EXPECT_GT(largest, 8U);
  }
}

double aspect_ratio(const TexturedTriangles& s, std::size_t t) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest = std::max(longest, (position(s, t, i) - position(s, t, (i + 1) % 3)).norm());
  return longest * longest / area_vector(s, t).norm();
}

double worst_aspect_ratio(const TexturedTriangles& s) {
  double worst = 0;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) worst = std::max(worst, aspect_ratio(s, t));
  return worst;
}

TEST(AspectRatio, IsKeptBelowTheLimit) {
  for (const TexturedTriangles& in : {sphere_with_charts().input, waves(2), polar_annulus().input}) {
    const double had = worst_aspect_ratio(in);
    for (const double limit : {1.2 * had, 3 * had}) {
      DecimateOptions options = to_faces(in.triangles.size() / 10);
      EXPECT_GT(worst_aspect_ratio(decimated(in, options).surface), 1.2 * had) << "the test says something";
      options.max_aspect_ratio = limit;
      const Left left = decimated(in, options);
      EXPECT_GT(left.result.collapsed, 0U);
      EXPECT_LE(worst_aspect_ratio(left.surface), limit * (1 + 1e-9));
    }
  }
}

TEST(AspectRatio, OfASurfaceThatIsWorseGetsNoWorse) {
  TexturedTriangles in = waves(1);
  for (Vec3& p : in.positions) p[0] *= 10;
  DecimateOptions options = to_faces(100);
  options.max_aspect_ratio = 5;
  const double had = worst_aspect_ratio(in);
  ASSERT_GT(had, 5);
  const Left left = decimated(in, options);
  EXPECT_LT(left.result.faces_after, left.result.faces_before);
  EXPECT_LE(worst_aspect_ratio(left.surface), had * (1 + 1e-9));
}

bool same(const TexturedTriangles& x, const TexturedTriangles& y) {
  const auto corners = [](const TexturedTriangles& s) {
    std::vector<std::int32_t> list;
    for (const auto& t : s.triangles)
      for (const auto& c : t) list.insert(list.end(), {c.position, c.texcoord});
    return list;
  };
  return x.positions == y.positions && x.texcoords == y.texcoords && corners(x) == corners(y);
}

TEST(Levels, AreMetInOrderAndChangeNothing) {
  for (const TexturedTriangles& in : {spot(), waves()}) {
    const std::size_t n = in.triangles.size();
    DecimateOptions options = to_faces(n / 10);
    const Left without = decimated(in, options);
    options.levels = {n + 5, n / 2, n / 2 - 1, n / 4, n / 10 + 1};
    TexturedSurface surface(in);
    std::vector<std::size_t> seen;
    std::vector<Index> source;
    options.on_level = [&](std::size_t level) {
      seen.push_back(level);
      EXPECT_LE(surface.live_triangles(), options.levels[level]);
      EXPECT_GE(surface.live_triangles() + 2, std::min(n, options.levels[level]));
      EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
      const TexturedTriangles now = surface.triangles(source);
      EXPECT_EQ(facts(now), facts(in));
      DecimateOptions alone = to_faces(options.levels[level]);
      EXPECT_TRUE(same(now, decimated(in, alone).surface)) << "a level is what a run of its own gives";
    };
    (void)decimate(surface, options);
    EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
    EXPECT_TRUE(same(surface.triangles(source), without.surface));
    EXPECT_EQ(source, without.source);
  }
}

TEST(Levels, ThatAreNotReachedAreNotSaid) {
  TexturedSurface surface(octahedron().input);
  DecimateOptions options = to_faces(1);
  options.levels = {100, 8, 4};
  std::vector<std::size_t> seen;
  options.on_level = [&](std::size_t level) { seen.push_back(level); };
  EXPECT_EQ(decimate(surface, options).faces_after, 8U);
  EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1})) << "the last collapse reaches the second one";
}

TEST(Levels, GoWithABoundInsteadOfATarget) {
  TexturedSurface surface(sphere_with_charts().input);
  DecimateOptions options;
  options.max_error = 0.01;
  options.levels = {1500, 1000};
  std::size_t calls = 0;
  options.on_level = [&](std::size_t) { ++calls; };
  EXPECT_LT(decimate(surface, options).faces_after, 1000U);
  EXPECT_EQ(calls, 2U);
}

void expect_refused(const DecimateOptions& options, const std::string& part) {
  TexturedSurface surface(two_charts().input);
  try {
    (void)decimate(surface, options);
    ADD_FAILURE() << part << " was not refused";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
  }
  EXPECT_EQ(surface.live_triangles(), surface.tree().mesh(NodeId::root).capacity(2)) << "nothing was done";
}

TEST(DecimateOptions, OutOfRangeAreRefusedWithTheirName) {
  const double nan = std::nan("");
  const auto with = [](double DecimateOptions::*member, double value) {
    DecimateOptions o = to_faces(100);
    o.*member = value;
    return o;
  };
  for (const double bad : {-1.0, nan}) {
    expect_refused(with(&DecimateOptions::max_error, bad), "max_error");
    expect_refused(with(&DecimateOptions::max_texture_error, bad), "max_texture_error");
    expect_refused(with(&DecimateOptions::max_normal_deviation, bad), "max_normal_deviation");
  }
  for (const double bad : {-1.0, 0.0, 1.0, 1.15, nan})
    expect_refused(with(&DecimateOptions::max_aspect_ratio, bad), "max_aspect_ratio");
  for (const double bad : {-0.1, 3.2, infinity, nan})
    expect_refused(with(&DecimateOptions::max_normal_turn, bad), "max_normal_turn");
  for (const auto weight : {&DecimateOptions::uv_weight, &DecimateOptions::curve_weight,
                            &DecimateOptions::seam_weight, &DecimateOptions::uv_curve_weight})
    for (const double bad : {-1e-9, infinity, nan}) expect_refused(with(weight, bad), "weights");
  for (const std::vector<std::size_t>& bad :
       {std::vector<std::size_t>{100}, {50}, {200, 200}, {200, 300}, {300, 100}, {0}}) {
    DecimateOptions o = to_faces(100);
    o.levels = bad;
    expect_refused(o, "levels");
  }
  DecimateOptions o;
  expect_refused(o, "target");
  o.max_normal_deviation = 0.1;
  o.levels = {10};
  expect_refused(o, "target");
}

// With another unwrapping of the same charts.
TEST(Weights, OfTheTextureZeroIgnoresWhereTextureCoordinatesAre) {
  const TexturedTriangles in = waves();
  TexturedTriangles other = in;
  for (Vec2& p : other.texcoords)
    p = Vec2(p[0] + 0.02 * std::sin(5 * p[1]), 1.5 * p[1] + 0.02 * std::sin(7 * p[0]));
  DecimateOptions options = to_faces(150);
  options.uv_weight = 0;
  const Left x = decimated(in, options), y = decimated(other, options);
  for (const auto& refused : x.result.refused) ASSERT_NE(refused.reason, "texture orientation");
  EXPECT_EQ(x.source, y.source);
  EXPECT_EQ(x.surface.positions, y.surface.positions);
  options.uv_weight = 1;
  EXPECT_NE(decimated(in, options).surface.positions, decimated(other, options).surface.positions);
}

TEST(Weights, OfTheTextureOneHasLessTextureDeviationThanZero) {
  // The texture is a projection along z, so that the deviation is that of (u, v) from (x, y).
  TexturedTriangles in = bare(grid(30, 30));
  for (Vec3& p : in.positions) p[2] = 2 * std::sin(p[0] * 0.6) * std::cos(p[1] * 0.5);
  add_texture(in, [](std::size_t, const Vec3& p) { return Vec2(p[0], p[1]); });
  const auto deviation = [&](double weight) {
    DecimateOptions options = to_faces(in.triangles.size() / 10);
    options.uv_weight = weight;
    const Left left = decimated(in, options);
    double sum = 0;
    for (const auto& t : left.surface.triangles)
      for (const auto& c : t) {
        const Vec3& p = left.surface.positions[static_cast<std::size_t>(c.position)];
        sum +=
            (left.surface.texcoords[static_cast<std::size_t>(c.texcoord)] - Vec2(p[0], p[1])).squared_norm();
      }
    return std::sqrt(sum);
  };
  EXPECT_LT(deviation(1), deviation(0) / 3);
}

TEST(Weights, ThatAreExtremeLeaveAValidResult) {
  for (const double weight : {0.0, 1e6})
    for (const auto which : {&DecimateOptions::uv_weight, &DecimateOptions::curve_weight,
                             &DecimateOptions::seam_weight, &DecimateOptions::uv_curve_weight})
      for (const TexturedTriangles& in : {waves(), sphere_with_charts().input, spot()}) {
        DecimateOptions options = to_faces(in.triangles.size() / 8);
        options.*which = weight;
        const Left left = decimated(in, options);
        EXPECT_EQ(left.result.stop, DecimateResult::Stop::faces);
        EXPECT_EQ(facts(left.surface), facts(in));
        EXPECT_EQ(newly_flipped(in, left.surface, left.source), 0U);
        EXPECT_TRUE(std::isfinite(left.result.max_cost));
        for (const Vec3& p : left.surface.positions) ASSERT_LT(p.norm(), 60);
        for (const Vec2& p : left.surface.texcoords) ASSERT_LT(p.norm(), 60);
      }
}

TEST(Weights, AllZeroLeaveAValidResult) {
  DecimateOptions options = to_faces(spot().triangles.size() / 10);
  options.uv_weight = options.curve_weight = options.seam_weight = options.uv_curve_weight = 0;
  const Left left = decimated(spot(), options);
  EXPECT_EQ(facts(left.surface), facts(spot()));
  EXPECT_EQ(newly_flipped(spot(), left.surface, left.source), 0U);
}

}  // namespace
}  // namespace multimesh::test
