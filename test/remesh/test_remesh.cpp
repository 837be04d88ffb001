// SPDX-License-Identifier: BSD-3-Clause
// Remeshing of textured surfaces: lengths, what is kept, positions and texture coordinates of vertices.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "multimesh/algorithms/compare.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/geometry/bounding_box.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;

double mean_length(const TexturedTriangles& s) {
  double sum = 0;
  for (const auto& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i)
      sum += (s.positions[std::size_t(t[i].position)] - s.positions[std::size_t(t[(i + 1) % 3].position)])
                 .norm();
  return sum / double(3 * s.triangles.size());
}

struct Remeshed {
  TexturedTriangles triangles;
  std::vector<Index> source;
  RemeshResult result;
};

Remeshed remeshed(const TexturedTriangles& input, double length, int iterations = 5,
                  const TexturedSurfaceOptions& curves = {}) {
  TexturedSurface surface(input, curves);
  RemeshOptions options;
  options.length = length;
  options.iterations = iterations;
  Remeshed r;
  r.result = remesh(surface, options);
  EXPECT_EQ(validate(surface.tree()), Problems{});
  r.triangles = surface.triangles(r.source);
  return r;
}

class RemeshMade : public testing::TestWithParam<MadeSurface> {};

// Finer, equal, coarser.
TEST_P(RemeshMade, KeepsTopologySeamsAndSides) {
  for (const double share : {0.4, 1.0, 1.7}) {
    SCOPED_TRACE(share);
    const TexturedTriangles& in = GetParam().input;
    const Remeshed r = remeshed(in, share * mean_length(in));
    EXPECT_EQ(facts(r.triangles), facts(in));
    EXPECT_EQ(newly_flipped(in, r.triangles, r.source), 0U);
  }
}

// A chart that is an affine map of its plane stays one, whatever moves inside it and along its seams.
TEST_P(RemeshMade, TextureCoordinatesAreThoseOfTheInputThere) {
  const MadeSurface& made = GetParam();
  if (made.maps.empty()) GTEST_SKIP() << "no affine charts";
  const Remeshed r = remeshed(made.input, 0.6 * mean_length(made.input));
  EXPECT_GT(r.result.moves, 0U);
  double worst = 0;
  for (std::size_t t = 0; t < r.triangles.triangles.size(); ++t) {
    const std::size_t chart = made.chart[r.source[t]];
    if (chart == no_texture) continue;
    for (const auto& c : r.triangles.triangles[t]) {
      const Vec2 should = made.maps[chart](r.triangles.positions[std::size_t(c.position)]);
      worst = std::max(worst, (r.triangles.texcoords[std::size_t(c.texcoord)] - should).norm());
    }
  }
  EXPECT_LT(worst, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, RemeshMade, testing::ValuesIn(made_surfaces()),
                         [](const auto& info) { return info.param.name; });

class RemeshSpot : public testing::TestWithParam<double> {};

TEST_P(RemeshSpot, ReachesTheLengthNearTheInput) {
  const double length = GetParam() * bounding_box_diagonal(spot().positions);
  const Remeshed r = remeshed(spot(), length, 10);
  EXPECT_GT(double(r.result.edges_in_range), 0.9 * double(r.result.edges));
  EXPECT_EQ(facts(r.triangles), facts(spot()));
  EXPECT_EQ(newly_flipped(spot(), r.triangles, r.source), 0U);
  const SurfaceComparison c = compare_surfaces(spot(), r.triangles, CompareOptions{.samples = 20000});
  EXPECT_LT(c.hausdorff, 0.5 * GetParam());
}

INSTANTIATE_TEST_SUITE_P(Lengths, RemeshSpot, testing::Values(0.015, 0.03), [](const auto& info) {
  return "PerMille" + std::to_string(std::lround(1000 * info.param));
});

/// Lengths of the edges of the surface's curves.
std::vector<double> curve_lengths(const TexturedTriangles& triangles) {
  TexturedSurface s(triangles);
  const Mesh& curves = s.tree().mesh(*s.seams());
  std::vector<double> lengths;
  for (Index e = 0; e < curves.capacity(1); ++e) {
    const Dart d = s.tree().to_root(*s.seams(), curves.dart_of(1, e));
    const Mesh& root = s.tree().mesh(NodeId::root);
    lengths.push_back(
        (s.positions()[root.vertex(d)] - s.positions()[root.vertex(root.reorder(d, exchange_ends))]).norm());
  }
  return lengths;
}

TEST(RemeshSeams, AreNotFrozen) {
  const double length = 0.5 * mean_length(spot());
  const Remeshed r = remeshed(spot(), length);
  const auto lengths = curve_lengths(r.triangles);
  const auto in_range = std::count_if(lengths.begin(), lengths.end(),
                                      [&](double l) { return l >= 0.8 * length && l <= 4.0 / 3 * length; });
  EXPECT_GT(double(in_range), 0.7 * double(lengths.size()));
}

TEST(RemeshSeams, StayAsTheyAreIfLocked) {
  TexturedSurface before(spot()), surface(spot());
  RemeshOptions options;
  options.length = 0.5 * mean_length(spot());
  options.iterations = 3;
  options.lock_seams = true;
  (void)remesh(surface, options);
  EXPECT_EQ(validate(surface.tree()), Problems{});
  const auto edges = [](const TexturedSurface& s) {
    const Mesh &curves = s.tree().mesh(*s.seams()), &root = s.tree().mesh(NodeId::root);
    std::vector<std::array<double, 6>> list;
    for (Index e = 0; e < curves.capacity(1); ++e) {
      if (!curves.is_live(1, e)) continue;
      const Dart d = s.tree().to_root(*s.seams(), curves.dart_of(1, e));
      Vec3 p = s.positions()[root.vertex(d)], q = s.positions()[root.vertex(root.reorder(d, exchange_ends))];
      if (q < p) std::swap(p, q);
      list.push_back({p[0], p[1], p[2], q[0], q[1], q[2]});
    }
    std::sort(list.begin(), list.end());
    return list;
  };
  EXPECT_EQ(edges(surface), edges(before));
  EXPECT_GT(surface.live_triangles(), 2 * before.live_triangles());
  EXPECT_FALSE(surface.tree().mesh(NodeId::root).is_locked(0));  // no lock is left
}

TEST(RemeshCurves, KeepSharpEdgesAndCorners) {
  TexturedTriangles box = cube(4);
  TexturedSurfaceOptions curves;
  curves.feature_angle = std::numbers::pi / 4;
  const Remeshed r = remeshed(box, 0.37, 6, curves);
  EXPECT_GT(double(r.result.edges_in_range),
            0.8 * double(r.result.edges));  // a grid's symmetry stays for long
  std::size_t corners = 0, on_edges = 0;
  for (const Vec3& p : r.triangles.positions) {
    int sides = 0;
    for (const double x : p) sides += std::abs(x) < 1e-12 || std::abs(x - 4) < 1e-12;
    EXPECT_GE(sides, 1) << testing::PrintToString(p);  // on the cube
    corners += sides == 3;
    on_edges += sides == 2;
  }
  EXPECT_EQ(corners, 8U);
  EXPECT_GT(on_edges, 12U * 8);  // 12 edges of 4 / 0.37
  TexturedSurface again(r.triangles, curves);
  EXPECT_EQ(report_features(again).curves, 12U);
}

TEST(Remesh, GivesTheSameTwice) {
  const double length = 1.3 * mean_length(spot());
  const Remeshed x = remeshed(spot(), length, 2), y = remeshed(spot(), length, 2);
  EXPECT_EQ(x.triangles.positions, y.triangles.positions);
  EXPECT_EQ(x.triangles.texcoords, y.triangles.texcoords);
  EXPECT_EQ(x.source, y.source);
}

TEST(Remesh, CanBeStoppedByAnException) {
  TexturedSurface surface(spot());
  RemeshOptions options;
  options.length = mean_length(spot());
  struct Enough {};
  options.progress = [](int round) {
    if (round == 2) throw Enough();
  };
  EXPECT_THROW((void)remesh(surface, options), Enough);
  EXPECT_EQ(validate(surface.tree()), Problems{});
}

TEST(Remesh, RefusesWhatMakesNoSense) {
  TexturedSurface surface(two_charts().input);
  for (const double length :
       {0.0, -1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    RemeshOptions options;
    options.length = length;
    EXPECT_THROW((void)remesh(surface, options), InputError) << length;
  }
  RemeshOptions options;
  options.length = 1;
  options.iterations = 0;
  EXPECT_THROW((void)remesh(surface, options), InputError);
}

TEST(Remesh, KeepsSeveralTexturesAndColors) {
  TexturedTriangles in = waves();
  add_uv_set(in, [&](std::size_t t, const Vec3& p) {
    return Vec2(p[1], centroid(in, t)[0] < 2 ? p[0] : p[0] + 50);
  });
  for (const Vec3& p : in.positions) in.colors.emplace_back(0.01 * p[0], 0.01 * p[1], 0.5);
  TexturedSurface surface(in);
  RemeshOptions options;
  options.length = 0.7 * mean_length(in);
  options.iterations = 3;
  const SurfaceReport before = report(surface);
  (void)remesh(surface, options);
  EXPECT_EQ(validate(surface.tree()), Problems{});
  const SurfaceReport after = report(surface);
  ASSERT_EQ(after.more_uv_sets.size(), before.more_uv_sets.size());
  EXPECT_EQ(after.more_uv_sets[0].texture.components, before.more_uv_sets[0].texture.components);
  EXPECT_EQ(after.texture->components, before.texture->components);
  EXPECT_EQ(surface.colors().size(), surface.positions().size());
}

}  // namespace
}  // namespace multimesh::test
