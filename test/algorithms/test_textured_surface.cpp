// SPDX-License-Identifier: BSD-3-Clause
// Converts to a TexturedSurface and back without an operation: nothing may be lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

/// A corner by value.
struct Corner {
  Vec3 position;
  bool textured;
  Vec2 texcoord;
  friend bool operator==(const Corner&, const Corner&) = default;
};

std::array<Corner, 3> corners(const TexturedTriangles& s, std::size_t t) {
  std::array<Corner, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& c = s.triangles[t][i];
    const bool textured = c.texcoord >= 0;
    result[i] = {s.positions[static_cast<std::size_t>(c.position)], textured,
                 textured ? s.texcoords[static_cast<std::size_t>(c.texcoord)] : Vec2(0, 0)};
  }
  return result;
}

bool equal_up_to_rotation(std::array<Corner, 3> x, const std::array<Corner, 3>& y) {
  for (int i = 0; i < 3; ++i, std::rotate(x.begin(), x.begin() + 1, x.end()))
    if (x == y) return true;
  return false;
}

std::size_t used_positions(const TexturedTriangles& s) {
  std::set<std::int32_t> used;
  for (const auto& t : s.triangles)
    for (const auto& c : t) used.insert(c.position);
  return used.size();
}

class RoundTrip : public ::testing::TestWithParam<MadeSurface> {};

TEST_P(RoundTrip, GivesTheSameTrianglesInTheirOwnOrientation) {
  const TexturedTriangles& in = GetParam().input;
  const TexturedSurface surface(in);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  ASSERT_EQ(out.triangles.size(), in.triangles.size());
  EXPECT_EQ(surface.live_triangles(), in.triangles.size());
  EXPECT_EQ(std::set<Index>(source.begin(), source.end()).size(), source.size());
  for (std::size_t t = 0; t < source.size(); ++t)
    ASSERT_TRUE(equal_up_to_rotation(corners(out, t), corners(in, source[t]))) << "triangle " << source[t];
}

TEST_P(RoundTrip, JoinsTheCopiesAndWritesEveryValueOnce) {
  const TexturedTriangles& in = GetParam().input;
  std::vector<Index> source;
  const TexturedTriangles out = TexturedSurface(in).triangles(source);
  EXPECT_EQ(out.positions.size(), used_positions(in));
  std::set<std::pair<double, double>> values;
  for (const auto& t : in.triangles)
    for (const auto& c : t)
      if (c.texcoord >= 0)
        values.emplace(in.texcoords[static_cast<std::size_t>(c.texcoord)][0],
                       in.texcoords[static_cast<std::size_t>(c.texcoord)][1]);
  EXPECT_EQ(out.texcoords.size(), values.size());
  EXPECT_EQ(facts(out), facts(in));
}

class ManifoldRoundTrip : public RoundTrip {};

TEST_P(ManifoldRoundTrip, ReportsWhatTheJudgeSees) {
  const TexturedSurface surface(GetParam().input);
  const Facts judged = facts(GetParam().input);
  const MeshReport root = report(surface.tree().mesh(NodeId::root));
  EXPECT_EQ(static_cast<long>(root.components), judged.surface.components);
  EXPECT_EQ(root.euler_characteristic, judged.surface.euler);
  EXPECT_EQ(static_cast<long>(root.boundary), judged.surface.boundary);
  EXPECT_EQ(static_cast<long>(report(surface.tree().mesh(*surface.texture())).components),
            judged.texture.components);
  EXPECT_EQ(surface.seams().has_value(),
            judged.seams.curves > 0 || surface.cut_report().reversed_triangles > 0);
}

std::vector<MadeSurface> manifold_surfaces() {
  std::vector<MadeSurface> all = made_surfaces();
  std::erase_if(all, [](const MadeSurface& m) {
    const Facts f = facts(m.input);
    return f.surface.crowded_edges + f.surface.pinched_vertices > 0;
  });
  return all;
}

const auto name_of = [](const auto& p) { return p.param.name; };
INSTANTIATE_TEST_SUITE_P(TexturedSurface, RoundTrip, ::testing::ValuesIn(made_surfaces()), name_of);
INSTANTIATE_TEST_SUITE_P(TexturedSurface, ManifoldRoundTrip, ::testing::ValuesIn(manifold_surfaces()),
                         name_of);

TexturedTriangles two_triangles(std::array<Vec2, 6> texcoords) {
  TexturedTriangles s;
  s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  s.texcoords.assign(texcoords.begin(), texcoords.end());
  s.triangles = {{{{0, 0}, {1, 1}, {2, 2}}}, {{{0, 3}, {2, 4}, {3, 5}}}};
  return s;
}

TEST(TexturedSurface, EqualValuesUnderDifferentIndicesAreNoSeam) {
  const TexturedSurface surface(two_triangles({{{0, 0}, {1, 0}, {1, 1}, {-0.0, 0}, {1, 1}, {0, 1}}}));
  EXPECT_FALSE(surface.seams());
  EXPECT_EQ(report(surface.tree().mesh(*surface.texture())).vertices, 4U);
}

TEST(TexturedSurface, OneDifferentValueMakesASeamThatEndsThere) {
  // The two triangles share one vertex of the texture only: they come apart there too, as charts that touch.
  const TexturedSurface surface(two_triangles({{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1.5}, {0, 1}}}));
  ASSERT_TRUE(surface.seams());
  EXPECT_EQ(report_seams(surface).edges, 1U);
  EXPECT_EQ(report(surface.tree().mesh(*surface.texture())).components, 2U);
}

TEST(TexturedSurface, SeamCurvesEndAtTheirJunctions) {
  const MadeSurface torus = tiled_torus();
  const TexturedSurface surface(torus.input);
  const SeamReport r = report_seams(surface);
  EXPECT_EQ(r.curves, 2U);
  EXPECT_EQ(r.ends, 0U);
  EXPECT_EQ(r.junctions, 1U);
  const MeshReport curves = report(surface.tree().mesh(*surface.seams()));
  EXPECT_EQ(curves.boundary, 4U) << "both closed seams are open curves, with their ends at the junction";
  EXPECT_EQ(r.edges, 48U);
}

TEST(TexturedSurface, SeamsOfAnOctahedronAreItsEdges) {
  const TexturedSurface surface(octahedron().input);
  const SeamReport r = report_seams(surface);
  EXPECT_EQ(r.curves, 12U);
  EXPECT_EQ(r.junctions, 6U);
  EXPECT_EQ(r.ends, 0U);
}

TEST(TexturedSurface, ASeamThatEndsInsideHasItsEndsCounted) {
  const TexturedSurface surface(slit().input);
  const SeamReport r = report_seams(surface);
  EXPECT_EQ(r.curves, 1U);
  EXPECT_EQ(r.ends, 2U) << "one inside, one on the boundary";
  EXPECT_EQ(report(surface.tree().mesh(*surface.texture())).components, 1U);
}

TEST(TexturedSurface, WithoutTextureThereIsNone) {
  const TexturedSurface surface(bare(sphere(1)));
  EXPECT_FALSE(surface.texture());
  EXPECT_FALSE(surface.seams());
  EXPECT_TRUE(surface.texcoords().empty());
  EXPECT_EQ(surface.cut_report().triangles_without_texcoords, 32U);
}

TEST(TexturedSurface, PositionsThatNoTriangleUsesAreLeftOut) {
  TexturedTriangles in = one_chart().input;
  in.positions.push_back({100, 100, 100});
  in.texcoords.push_back({100, 100});
  const TexturedSurface surface(in);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  EXPECT_EQ(out.positions.size(), in.positions.size() - 1);
}

}  // namespace
}  // namespace multimesh::test
