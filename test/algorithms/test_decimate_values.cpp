// SPDX-License-Identifier: BSD-3-Clause
// What a surface carries besides one texture: more UV sets, colours, hard edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/domains/shading.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/decimate_cost_name.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

DecimateOptions to_ratio(const TexturedTriangles& s, double ratio) {
  DecimateOptions o;
  o.faces = std::max<std::size_t>(1, static_cast<std::size_t>(ratio * double(s.triangles.size())));
  return o;
}

struct UvCase {
  std::string name;
  TexturedTriangles input;
};

void PrintTo(const UvCase& c, std::ostream* out) {
  *out << c.name;
}

/// A second set whose seams cross those of the first one, and a third of one chart of the upper half.
TexturedTriangles with_sets(TexturedTriangles s, double middle) {
  add_uv_set(s, [&](std::size_t t, const Vec3& p) {
    const bool upper = centroid(s, t)[1] > middle;  // mirrored there
    return Vec2((upper ? -1 : 1) * p[0] + (upper ? 100 : 0), p[1] + p[2] / 4);
  });
  add_uv_set(
      s, [](std::size_t, const Vec3& p) { return Vec2(p[0] + 0.2 * p[2], p[1]); },
      [&](std::size_t t) { return centroid(s, t)[1] > middle; });
  return s;
}

/// A sphere with eight charts and, in a second set, two: the halves seen from above and below.
TexturedTriangles sphere_with_halves() {
  TexturedTriangles s = sphere_with_charts().input;
  add_uv_set(s, [&](std::size_t t, const Vec3& p) {
    const double side = centroid(s, t)[2] > 0 ? 1 : -1;
    return Vec2(p[0], p[1]) / (1 + side * p[2]) + Vec2(3 * side, 0);
  });
  return s;
}

/// Where the seam of the first set runs, the second one is cut in the upper half only.
TexturedTriangles with_slit_on_seam() {
  TexturedTriangles s = waves();
  add_uv_set(s, [&](std::size_t t, const Vec3& p) {
    const double cut = centroid(s, t)[0] < 10 ? 0 : std::max(0.0, p[1] - 10);
    return Vec2(p[0] + cut, p[1]);
  });
  return s;
}

std::vector<UvCase> uv_cases() {
  return {{"Flat", with_sets(two_charts().input, 10)},
          {"Waves", with_sets(waves(), 10)},
          {"Steep", with_sets(waves(4), 10)},
          {"SlitOnSeam", with_slit_on_seam()},
          {"Slit", with_sets(slit().input, 10)},
          {"Half", with_sets(half_without().input, 10)},
          {"Touching", with_sets(touching_charts().input, 10)},
          {"Sphere", sphere_with_halves()}};
}

class SeveralSets : public ::testing::TestWithParam<std::tuple<UvCase, double, DecimateCost>> {};

TEST_P(SeveralSets, AllKeepTopologyAndOrientation) {
  const auto& [made, ratio, cost] = GetParam();
  TexturedSurface surface(made.input);
  DecimateOptions options = to_ratio(made.input, ratio);
  options.cost = cost;
  const DecimateResult r = decimate(surface, options);
  EXPECT_LT(r.faces_after, r.faces_before / 4 * 3);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  ASSERT_EQ(out.uv_sets(), made.input.uv_sets());
  for (std::size_t set = 0; set < out.uv_sets(); ++set) {
    const TexturedTriangles before = only_uv_set(made.input, set), after = only_uv_set(out, set);
    EXPECT_EQ(facts(after), facts(before)) << "set " << set;
    EXPECT_EQ(newly_flipped(before, after, source), 0U) << "set " << set;
  }
}

INSTANTIATE_TEST_SUITE_P(Made, SeveralSets,
                         ::testing::Combine(::testing::ValuesIn(uv_cases()),
                                            ::testing::Values(0.5, 0.1, 0.001),
                                            ::testing::Values(DecimateCost::quadric, DecimateCost::length)),
                         [](const auto& p) {
                           return std::get<0>(p.param).name +
                                  std::to_string(std::lround(1000 * std::get<1>(p.param))) +
                                  name_of(std::get<2>(p.param));
                         });

// On a plane, the affine maps of both sets must be preserved: each set follows the other.
TEST(SeveralSets, OfAPlaneStayAffine) {
  TexturedTriangles in = bare(grid(20, 20));
  const auto first = [](const Vec3& p) { return Vec2(0.3 * p[0] + 0.1 * p[1], 0.2 * p[1] - 1); };
  const auto second = [](const Vec3& p) { return Vec2(5 * p[1] - p[0], 4 * p[0] + p[1]); };
  add_texture(in, [&](std::size_t, const Vec3& p) { return first(p); });
  add_uv_set(in, [&](std::size_t, const Vec3& p) { return second(p); });
  TexturedSurface surface(in);
  (void)decimate(surface, to_ratio(in, 0.02));
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  EXPECT_LT(out.triangles.size(), 40U);
  for (std::size_t t = 0; t < out.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = out.positions[static_cast<std::size_t>(out.triangles[t][i].position)];
      const auto uv = [&](std::size_t set) {
        return out.texcoords_of(set)[static_cast<std::size_t>(out.texcoord(set, t, i))];
      };
      EXPECT_LT((uv(0) - first(p)).norm(), 1e-7);
      EXPECT_LT((uv(1) - second(p)).norm(), 1e-6);
    }
}

/// Doubled, with sign.
double area_in_texture(const TexturedTriangles& s, std::size_t t) {
  const auto uv = [&](std::size_t i) {
    return s.texcoords[static_cast<std::size_t>(s.triangles[t][i].texcoord)];
  };
  const Vec2 u = uv(1) - uv(0), v = uv(2) - uv(0);
  return u[0] * v[1] - u[1] * v[0];
}

// As when both halves of a symmetric model share their part of the texture: neither of them is on the wrong
// side.
TEST(FoldedChart, KeepsTheOrientationOfBothHalves) {
  for (const double fold : {10.0, 9.0, 12.0}) {
    TexturedTriangles in = bare(grid(20, 20));
    for (Vec3& p : in.positions) p[2] = 2 * std::sin(0.7 * p[0]) * std::cos(0.9 * p[1]);
    add_texture(in, [&](std::size_t, const Vec3& p) { return Vec2(std::abs(p[0] - fold), p[1]); });
    for (const double ratio : {0.3, 0.1, 0.03}) {
      TexturedSurface surface(in);
      DecimateOptions options = to_ratio(in, ratio);
      options.uv_weight = 0;  // nothing else keeps triangles from flipping
      options.cost = DecimateCost::length;
      ASSERT_GT(decimate(surface, options).collapsed, 0U);
      std::vector<Index> source;
      const TexturedTriangles out = surface.triangles(source);
      std::size_t flipped = 0;
      for (std::size_t t = 0; t < source.size(); ++t)
        flipped += area_in_texture(out, t) * area_in_texture(in, source[t]) <= 0;
      EXPECT_EQ(flipped, 0U) << "folded at " << fold << ", of " << source.size();
    }
  }
}

TEST(SeveralSets, MoreThanFourAreRefused) {
  TexturedTriangles in = one_chart().input;
  for (int i = 0; i < 4; ++i) add_uv_set(in, [](std::size_t, const Vec3& p) { return Vec2(p[0], p[1]); });
  TexturedSurface surface(in);
  EXPECT_THROW((void)decimate(surface, to_ratio(in, 0.5)), InputError);
  in.more_uv_sets.pop_back();
  TexturedSurface fewer(in);
  EXPECT_EQ(decimate(fewer, to_ratio(in, 0.1)).stop, DecimateResult::Stop::faces);
}

TEST(Colors, StayInTheRangeOfTheInput) {
  for (const DecimateCost cost : {DecimateCost::quadric, DecimateCost::length})
    for (MadeSurface made : {sphere_with_charts(), slit(), book()}) {
      std::mt19937 random(4);
      std::uniform_real_distribution<double> red(0.2, 0.4), green(0.0, 1.0), blue(0.7, 0.75);
      for (std::size_t v = 0; v < made.input.positions.size(); ++v)
        made.input.colors.push_back({red(random), green(random), blue(random)});
      TexturedSurface surface(made.input);
      DecimateOptions options = to_ratio(made.input, 0.1);
      options.cost = cost;
      ASSERT_GT(decimate(surface, options).collapsed, 0U);
      std::vector<Index> source;
      const TexturedTriangles out = surface.triangles(source);
      ASSERT_EQ(out.colors.size(), out.positions.size());
      std::set<double> greens;
      for (const Vec3& c : out.colors) {
        EXPECT_TRUE(c[0] >= 0.2 && c[0] <= 0.4 && c[1] >= 0 && c[1] <= 1 && c[2] >= 0.7 && c[2] <= 0.75)
            << testing::PrintToString(c);
        greens.insert(c[1]);
      }
      EXPECT_GT(greens.size(), out.colors.size() / 2) << "they are not all the same one";
    }
}

// By length, vertices are put on the edge: colours that are an affine function of position stay so.
TEST(Colors, AreInterpolatedWherePositionsAre) {
  TexturedTriangles in = waves(2);
  const auto color = [](const Vec3& p) {
    return Vec3(p[0] / 40 + p[1] / 80, 0.5 - p[2] / 8, p[0] / 30 + 0.1 * (p[2] + 2) / 8);
  };
  for (const Vec3& p : in.positions) in.colors.push_back(color(p));
  TexturedSurface surface(in);
  DecimateOptions options = to_ratio(in, 0.2);
  options.cost = DecimateCost::length;
  (void)decimate(surface, options);
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  for (std::size_t v = 0; v < out.positions.size(); ++v)
    EXPECT_LT((out.colors[v] - color(out.positions[v])).norm(), 1e-12);
}

TEST(Colors, OfVerticesThatStayAreKept) {
  TexturedTriangles in = two_charts().input;
  std::map<Vec3, Vec3> color_at;
  for (std::size_t v = 0; v < in.positions.size(); ++v) {
    in.colors.push_back({double(v % 7) / 7, double(v % 11) / 11, double(v % 13) / 13});
    color_at[in.positions[v]] = in.colors.back();
  }
  TexturedSurface surface(in);
  DecimateOptions options = to_ratio(in, 0.2);
  options.lock_boundary = options.lock_seams = true;
  (void)decimate(surface, options);
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  std::size_t checked = 0;
  for (std::size_t v = 0; v < out.positions.size(); ++v) {
    const Vec3& p = out.positions[v];
    if (p[0] != 0 && p[0] != 10 && p[0] != 20 && p[1] != 0 && p[1] != 20) continue;
    ASSERT_TRUE(color_at.contains(p));
    EXPECT_EQ(out.colors[v], color_at[p]);
    ++checked;
  }
  EXPECT_GE(checked, 99U);
}

/// Shaded flat: the normals are those of the cube's six faces.
TexturedTriangles shaded_cube(int n) {
  TexturedTriangles s = cube(n);
  std::vector<Vec3> normals;
  std::vector<std::array<std::int32_t, 3>> corners(s.triangles.size());
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto p = [&](std::size_t i) {
      return s.positions[static_cast<std::size_t>(s.triangles[t][i].position)];
    };
    corners[t].fill(static_cast<std::int32_t>(t));
    normals.push_back(cross(p(1) - p(0), p(2) - p(0)).normalized());
  }
  s.shading = shading(s, normals, corners);
  return s;
}

// The hard edges are the sharp ones there, and all edges of a curve stay hard.
TEST(HardEdges, OfACubeStayItsTwelveEdges) {
  for (const double ratio : {0.5, 0.1, 0.001}) {
    TexturedSurface surface(shaded_cube(10), {.feature_angle = 1});
    ASSERT_TRUE(surface.has_normals());
    (void)decimate(surface, to_ratio(cube(10), ratio));
    const Mesh& root = surface.tree().mesh(NodeId::root);
    std::size_t hard = 0;
    for (Index e = 0; e < root.capacity(1); ++e) {
      if (!root.is_live(1, e)) continue;
      EXPECT_EQ(surface.hard(e), surface.curve_kinds(root.dart_of(1, e)) == sharp_curve);
      hard += surface.hard(e);
    }
    EXPECT_EQ(hard, report_features(surface).edges);
    EXPECT_GE(hard, 12U);
  }
}

// No curve protects these: a band of hard edges around a smooth sphere. It must stay a closed ring.
TEST(HardEdges, OfARingStayARing) {
  TexturedSurface surface(shaded_cube(10));
  std::size_t before = 0, after = 0;
  const auto count_odd = [&](std::size_t& hard) {
    const Mesh& root = surface.tree().mesh(NodeId::root);
    std::map<Index, int> degree;
    hard = 0;
    for (Index e = 0; e < root.capacity(1); ++e) {
      if (!root.is_live(1, e) || !surface.hard(e)) continue;
      ++hard;
      const Dart d = root.dart_of(1, e);
      ++degree[root.vertex(d)], ++degree[root.vertex(root.switch_dart(d, 0))];
    }
    std::size_t ends = 0;
    for (const auto& [v, n] : degree) ends += n == 1;
    return ends;
  };
  EXPECT_EQ(count_odd(before), 0U);
  (void)decimate(surface, to_ratio(cube(10), 0.1));
  EXPECT_EQ(count_odd(after), 0U) << "lines of hard edges do not come to end anywhere";
  EXPECT_GE(after, 12U);
  EXPECT_LT(after, before);
}

}  // namespace
}  // namespace multimesh::test
