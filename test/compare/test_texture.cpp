// SPDX-License-Identifier: BSD-3-Clause
// What a texture image shows on another surface: deviations, cracks and flips that are known.
#include <gtest/gtest.h>

#include <numbers>

#include "multimesh/algorithms/comparison/texture_map.hpp"
#include "test/compare/plane.hpp"

namespace multimesh::test {
namespace {

constexpr double tiny = 1e-12;
const double diagonal = std::sqrt(2.0);
constexpr Part middle{0.25, 0.75, 0.25, 0.75, 4, 4};

CompareOptions few(std::size_t samples = 2000) {
  CompareOptions o;
  o.samples = samples;
  return o;
}

/// The middle of the plane, its texture coordinates moved.
TexturedTriangles shifted(const Vec2& by) {
  return plane(middle, [&](const Vec3& p, const Vec3&) { return Vec2(p[0] / 4, p[1] / 4) + by; });
}

/// The square in two charts, cut at x = 1/2, the right one moved by `right` in its texture coordinates.
TexturedTriangles two_charts(const Part& part, const Vec2& right) {
  return plane(part, [&](const Vec3& p, const Vec3& centroid) {
    return Vec2(p[0], p[1]) + (centroid[0] > 0.5 ? right : Vec2(0, 0));
  });
}

TEST(CompareTexture, OfASurfaceWithItselfDiffersInNothing) {
  for (const auto& s : {plane(), two_charts({}, {2, 0})}) {
    const auto c = compare_surfaces(s, s, few());
    ASSERT_TRUE(c.texture);
    EXPECT_LT(c.texture->deviation.max, tiny);
    EXPECT_LT(c.texture->crack.max, tiny);
    EXPECT_EQ(c.texture->outside, 0);
    EXPECT_EQ(c.texture->color_psnr, std::numeric_limits<double>::infinity());
  }
}

TEST(CompareTexture, DeviationOfShiftedTextureCoordinates) {
  const auto c = compare_surfaces(plane(), shifted({0.03, -0.04}), few());
  const double expected = 4 * 0.05 / diagonal;
  for (const double d : {c.texture->deviation.rms, c.texture->deviation.mean, c.texture->deviation.p95,
                         c.texture->deviation.max})
    EXPECT_NEAR(d, expected, 2.1e-5) << "what lies closer than `touching` may count";
  EXPECT_EQ(c.texture->outside, 0);
  EXPECT_LT(c.to_original.max, tiny) << "the surface itself is where it was";
}

TEST(CompareTexture, DeviationOfScaledTextureCoordinates) {
  // uv(p) = (x/4 + x/40, y/4): |p - X(uv(p))| = x/10 for x in [1/4, 3/4].
  const auto other = plane(middle, [](const Vec3& p, const Vec3&) { return Vec2(p[0] * 0.275, p[1] / 4); });
  const auto d = compare_surfaces(plane(), other, few(20000)).texture->deviation;
  EXPECT_NEAR(d.mean, 0.05 / diagonal, 1e-4);
  EXPECT_NEAR(d.rms, 0.1 * std::sqrt(13.0 / 48) / diagonal, 1e-4);
  EXPECT_NEAR(d.p95, 0.0725 / diagonal, 1e-3);
  EXPECT_NEAR(d.max, 0.075 / diagonal, 1e-3);
}

TEST(CompareTexture, OutsideOfTheAtlasItsNearestPointCounts) {
  // Moved by a quarter of the square to the right: of [1/4, 3/4] nothing is outside; by a half, one half is.
  EXPECT_EQ(compare_surfaces(plane(), shifted({0.0624, 0}), few()).texture->outside, 0);
  const auto c = compare_surfaces(plane(), shifted({0.125, 0}), few());
  EXPECT_NEAR(c.texture->outside, 0.5, 0.01);
  EXPECT_LT(c.texture->deviation.max, 0.5 / diagonal + tiny);
  EXPECT_NEAR(c.texture->deviation.mean, 0.4375 / diagonal, 1e-3) << "from 1/2 down to 1/4 on the right half";
}

TEST(CompareTexture, OfOverlappingChartsTheNearerPlaceCounts) {
  const auto stacked = two_charts({}, {-0.5, 0});
  const auto c = compare_surfaces(stacked, stacked, few());
  EXPECT_LT(c.texture->deviation.max, tiny);
  EXPECT_LT(c.texture->crack.max, 0.5 / diagonal + tiny);
}

TEST(CompareTexture, ThePlacesDoNotDependOnWhereTheyAreLookedForFirst) {
  using comparison::TextureMap;
  for (const Vec2& right : {Vec2(2, 0), Vec2(-0.5, 0), Vec2(-0.3, 0.1)}) {
    const auto surface = two_charts({0, 1, 0, 1, 20, 20}, right);
    const TextureMap by_texture(surface, TextureMap::Search::texture),
        by_space(surface, TextureMap::Search::space);
    std::vector<spatial::Nearby> buffer;
    for (int i = 0; i < 50; ++i)
      for (int j = 0; j < 50; ++j) {
        const Vec2 uv(-0.3 + 0.033 * i, -0.2 + 0.029 * j);
        const Vec3 near(0.02 * j, 0.02 * i, 0.1);
        const auto a = by_texture(uv, near, buffer), b = by_space(uv, near, buffer);
        EXPECT_EQ(a.triangle, b.triangle);
        EXPECT_EQ(a.position, b.position);
        EXPECT_NEAR(a.uv_distance, b.uv_distance, by_space.touching());
      }
  }
}

TEST(CompareTexture, AllTrianglesInOnePointOfTheTexture) {
  auto dummy = plane({0, 1, 0, 1, 60, 60});
  for (auto& p : dummy.texcoords) p = {0, 0};
  const auto c = compare_surfaces(dummy, dummy, few());
  EXPECT_EQ(c.original.zero_area, 7200U);
  EXPECT_LT(c.texture->deviation.max, 0.02 / diagonal) << "a corner of the own triangle is never far";
}

TEST(CompareTexture, ColoursOfASmallShift) {
  // color_pattern.hpp says how fast the colours change.
  const double s = 4 * 0.0005 / diagonal;
  const auto c = compare_surfaces(plane(), shifted({0.0003, -0.0004}), few(20000));
  const double rms = 2 * std::numbers::pi * std::sqrt(265.0 / 96) * s;
  EXPECT_NEAR(c.texture->color_psnr, -20 * std::log10(rms), 1.0) << "few waves, not quite an average";
}

TEST(CompareTexture, ACrackHasItsWidth) {
  // The right side of the seam shows what is 0.01 farther up.
  const auto original = two_charts({}, {2, 0});
  const auto c = compare_surfaces(original, two_charts({0.25, 0.75, 0.25, 0.75, 4, 4}, {2, 0.01}), few());
  EXPECT_NEAR(c.texture->crack.rms, 0.01 / diagonal, 5e-5);
  EXPECT_NEAR(c.texture->crack.max, 0.01 / diagonal, 5e-5);
  EXPECT_EQ(c.other.meshes->seams->edges, 4U);
  EXPECT_LT(c.texture->deviation.rms, 0.01 / diagonal);
}

TEST(CompareTexture, FlipsAreCountedAgainstTheOriginalsCharts) {
  const auto mirror = [](TexturedTriangles s, bool all) {
    for (std::size_t i = 0; i < s.texcoords.size(); ++i)
      if (all || s.texcoords[i][0] > 1.5) s.texcoords[i][0] = 4 - s.texcoords[i][0];
    return s;
  };
  const auto original = two_charts({}, {2, 0}), with_mirrored = mirror(original, false);
  auto c = compare_surfaces(with_mirrored, with_mirrored, few());
  EXPECT_EQ(c.original.flipped, 0U) << "a mirrored chart is no flip";
  EXPECT_EQ(c.other.flipped, 0U);

  auto other = with_mirrored;
  std::swap(other.texcoords[0], other.texcoords[1]);  // one triangle turned over
  other.texcoords[30] = other.texcoords[31];          // and one without area
  c = compare_surfaces(with_mirrored, other, few());
  EXPECT_EQ(c.other.flipped, 1U);
  EXPECT_EQ(c.other.zero_area, 1U);
  EXPECT_EQ(c.original.zero_area, 0U);

  // The texture that is the original's, used from behind: all of it is flipped.
  const auto one = plane();
  auto behind = one;
  for (auto& p : behind.texcoords) p[0] = 0.25 - p[0];
  EXPECT_EQ(compare_surfaces(one, behind, few()).other.flipped, 128U);
}

TEST(CompareTexture, TheNumberOfThreadsChangesNothing) {
  const auto original = two_charts({0, 1, 0, 1, 40, 40}, {2, 0});
  const auto other = two_charts({0, 1, 0, 1, 6, 5}, {2.01, 0.003});
  auto options = few(10000);
  options.per_vertex = true;
  options.threads = 1;
  const auto one = compare_surfaces(original, other, options);
  for (const unsigned threads : {2U, 7U, 0U}) {
    options.threads = threads;
    const auto c = compare_surfaces(original, other, options);
    EXPECT_EQ(c.rms, one.rms);
    EXPECT_EQ(c.hausdorff, one.hausdorff);
    EXPECT_EQ(c.texture->deviation.rms, one.texture->deviation.rms);
    EXPECT_EQ(c.texture->deviation.mean, one.texture->deviation.mean);
    EXPECT_EQ(c.texture->deviation.p95, one.texture->deviation.p95);
    EXPECT_EQ(c.texture->color_psnr, one.texture->color_psnr);
    EXPECT_EQ(c.texture->crack.rms, one.texture->crack.rms);
    EXPECT_EQ(c.texture->outside, one.texture->outside);
    EXPECT_EQ(c.vertex_distance, one.vertex_distance);
    EXPECT_EQ(c.vertex_deviation, one.vertex_deviation);
  }
}

}  // namespace
}  // namespace multimesh::test
