// SPDX-License-Identifier: BSD-3-Clause
// Distances that are known, and what holds for all comparisons.
#include <gtest/gtest.h>

#include "multimesh/algorithms/comparison/parallel.hpp"
#include "multimesh/algorithms/comparison/samples.hpp"
#include "multimesh/error.hpp"
#include "test/compare/plane.hpp"

namespace multimesh::test {
namespace {

constexpr double tiny = 1e-13;
const double diagonal = std::sqrt(2.0);  // of the unit square

CompareOptions few(std::size_t samples = 2000) {
  CompareOptions o;
  o.samples = samples;
  return o;
}

TexturedTriangles moved(TexturedTriangles s, const Vec3& by) {
  for (auto& p : s.positions) p += by;
  return s;
}

TEST(CompareDistance, OfASurfaceToItselfIsZero) {
  const auto c = compare_surfaces(plane(), plane(), few());
  EXPECT_NEAR(c.diagonal, diagonal, tiny);
  EXPECT_LT(c.hausdorff, tiny);
  EXPECT_LT(c.rms, tiny);
}

TEST(CompareDistance, TheTriangulationOfAPlaneDoesNotMatter) {
  const auto c = compare_surfaces(plane({0, 1, 0, 1, 7, 3}), plane({0, 1, 0, 1, 2, 1}), few());
  EXPECT_LT(c.hausdorff, tiny);
  EXPECT_LT(c.texture->deviation.max, tiny);
}

TEST(CompareDistance, OfAPlaneMovedAlongItsNormal) {
  const auto c = compare_surfaces(plane(), moved(plane(), {0, 0, 0.25}), few());
  for (const double d :
       {c.to_original.rms, c.to_original.max, c.from_original.rms, c.from_original.max, c.rms, c.hausdorff})
    EXPECT_NEAR(d, 0.25 / diagonal, tiny);
}

TEST(CompareDistance, ScaleAndPlaceDoNotMatter) {
  auto a = plane(), b = moved(plane(), {0, 0, 0.25});
  for (auto* s : {&a, &b})
    for (auto& p : s->positions) p = p * 1e-4 + Vec3(100, -200, 300);
  const auto c = compare_surfaces(a, b, few());
  EXPECT_NEAR(c.hausdorff, 0.25 / diagonal, 1e-8);
  EXPECT_NEAR(c.rms, 0.25 / diagonal, 1e-8);
}

TEST(CompareDistance, HasTwoSides) {
  // The right half of the square is missing: rms^2 = integral of (x - 1/2)^2 over [1/2, 1] = 1/24.
  const auto c = compare_surfaces(plane(), plane({0, 0.5, 0, 1}), few(20000));
  EXPECT_LT(c.to_original.max, tiny);
  EXPECT_NEAR(c.from_original.max, 0.5 / diagonal, tiny) << "at vertices, whatever the samples";
  EXPECT_NEAR(c.from_original.rms, std::sqrt(1.0 / 24) / diagonal, 1e-3);
  EXPECT_NEAR(c.rms, c.from_original.rms / std::sqrt(2.0), tiny);
}

TEST(CompareDistance, PerVertexIsThatOfEachPosition) {
  auto b = plane();
  b.positions[10][2] = -0.1;
  b.positions.push_back({7, 7, 7});  // of no triangle
  auto o = few();
  o.per_vertex = true;
  const auto c = compare_surfaces(plane(), b, o);
  ASSERT_EQ(c.vertex_distance.size(), b.positions.size());
  for (std::size_t v = 0; v < b.positions.size(); ++v)
    EXPECT_NEAR(c.vertex_distance[v], v == 10 ? 0.1 / diagonal : 0, tiny);
  EXPECT_EQ(c.hausdorff, c.vertex_distance[10]);
  ASSERT_EQ(c.vertex_deviation.size(), b.positions.size());
  EXPECT_NEAR(c.vertex_deviation[10], 0.1 / diagonal, tiny);
  EXPECT_TRUE(compare_surfaces(plane(), b, few()).vertex_distance.empty());
}

TEST(Compare, WithoutATextureThereIsNoTextureToCompare) {
  auto bare = plane();
  for (auto& t : bare.triangles)
    for (auto& c : t) c.texcoord = -1;
  for (const auto& c : {compare_surfaces(bare, plane(), few()), compare_surfaces(plane(), bare, few()),
                        compare_surfaces(bare, bare, few())}) {
    EXPECT_FALSE(c.texture);
    EXPECT_LT(c.hausdorff, tiny);
    EXPECT_EQ(c.original.flipped + c.other.flipped + c.original.zero_area + c.other.zero_area, 0U);
  }
  EXPECT_EQ(compare_surfaces(bare, plane(), few()).original.untextured, 128U);
}

TEST(Compare, TopologyIsThatOfTheReports) {
  const auto c = compare_surfaces(plane(), plane({0, 1, 0, 1, 1, 1}), few());
  ASSERT_TRUE(c.original.meshes && c.original.meshes->texture);
  EXPECT_EQ(c.original.meshes->surface.faces, 128U);
  EXPECT_EQ(c.original.meshes->texture->components, 1U);
  EXPECT_EQ(c.other.meshes->surface.faces, 2U);
  EXPECT_EQ(c.other.triangles, 2U);
  auto o = few();
  o.topology = false;
  EXPECT_FALSE(compare_surfaces(plane(), plane(), o).original.meshes);
}

TEST(Compare, BadInputIsRefusedByName) {
  const auto refused = [](const TexturedTriangles& a, const TexturedTriangles& b, const std::string& part) {
    try {
      (void)compare_surfaces(a, b, few());
      ADD_FAILURE() << "not refused: " << part;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
  };
  refused({}, plane(), "original");
  refused(plane(), {}, "other");
  auto wrong = plane();
  wrong.triangles[5][1].position = 5000;
  refused(plane(), wrong, "triangle 5");
  auto point = plane();
  for (auto& p : point.positions) p = {1, 2, 3};
  refused(point, plane(), "single point");
}

TEST(Samples, AreUniformOverTheArea) {
  // A triangle of area 3, one without, one of area 1.
  TexturedTriangles s;
  s.positions = {{0, 0, 0}, {3, 0, 0}, {0, 2, 0}, {1, 0, 0}};
  s.triangles = {{{{0}, {1}, {2}}}, {{{0}, {1}, {3}}}, {{{0}, {3}, {2}}}};
  const auto samples = comparison::sample(s, 4000, 7);
  ASSERT_EQ(samples.size(), 4000U);
  std::array<std::size_t, 3> count{};
  Vec3 mean(0, 0, 0);
  for (const auto& x : samples) {
    ++count[x.triangle];
    const auto& w = x.barycentric;
    EXPECT_GE(std::min({w[0], w[1], w[2]}), 0);
    EXPECT_NEAR(w[0] + w[1] + w[2], 1, 1e-15);
    if (x.triangle == 0) mean += Vec3(w[0], w[1], w[2]) / 3000;
  }
  EXPECT_EQ(count, (std::array<std::size_t, 3>{3000, 0, 1000}));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(mean[i], 1.0 / 3, 0.02);
}

TEST(Samples, FollowTheSeed) {
  const auto a = comparison::sample(plane(), 100, 1), b = comparison::sample(plane(), 100, 1),
             c = comparison::sample(plane(), 100, 2);
  bool differ = false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].barycentric, b[i].barycentric);
    differ |= a[i].barycentric != c[i].barycentric;
  }
  EXPECT_TRUE(differ);
}

TEST(Parallel, CoversEverythingOnceAndPassesExceptionsOn) {
  for (const unsigned threads : {0U, 1U, 3U, 50U}) {
    std::vector<int> done(10000, 0);
    comparison::for_each_block(done.size(), threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) ++done[i];
    });
    EXPECT_EQ(std::count(done.begin(), done.end(), 1), 10000);
    EXPECT_THROW(comparison::for_each_block(done.size(), threads,
                                            [](std::size_t, std::size_t) { throw InputError("no"); }),
                 InputError);
  }
  comparison::for_each_block(0, 2, [](std::size_t, std::size_t) { ADD_FAILURE(); });
}

}  // namespace
}  // namespace multimesh::test
