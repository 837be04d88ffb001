// SPDX-License-Identifier: BSD-3-Clause
// Input that is not manifold: how much is cut, how this is reported, and that it is joined again.
#include <gtest/gtest.h>

#include <cmath>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

using Corners = std::array<std::int32_t, 3>;

TexturedTriangles triangles(std::vector<Vec3> positions, const std::vector<Corners>& list) {
  TexturedTriangles s;
  s.positions = std::move(positions);
  for (const Corners& t : list) s.triangles.push_back({{{t[0], -1}, {t[1], -1}, {t[2], -1}}});
  return s;
}

TexturedTriangles unit_tetrahedron_corners(const std::vector<Corners>& list) {
  return triangles({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}, list);
}

struct Expected {
  std::size_t copies, reversed, components, crowded, against;
};

void expect_cut(const TexturedTriangles& in, const Expected& e) {
  const TexturedSurface surface(in);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  EXPECT_EQ(surface.cut_report().copied_vertices, e.copies);
  EXPECT_EQ(surface.cut_report().reversed_triangles, e.reversed);
  EXPECT_EQ(report(surface.tree().mesh(NodeId::root)).components, e.components);
  const ManifoldReport m = report_manifoldness(in, surface);
  EXPECT_EQ(m.edges_with_three_or_more, e.crowded);
  EXPECT_EQ(m.inconsistent_edges, e.against);
  EXPECT_EQ(m.cut_vertices, e.copies);
  std::vector<Index> source;
  EXPECT_EQ(facts(surface.triangles(source)), facts(in)) << "copies are joined again";
}

TEST(CutReport, ManifoldInputIsLeftAlone) {
  expect_cut(unit_tetrahedron_corners({{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}), {0, 0, 1, 0, 0});
}

//   1            Three triangles at the edge 0-1: each becomes a sheet of its own.
//  /|\ .
// 2 | 4   (3 in front)
//  \|/
//   0
TEST(CutReport, AnEdgeWithThreeTrianglesComesApart) {
  expect_cut(unit_tetrahedron_corners({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), {4, 0, 3, 1, 0});
}

// 1---2   3
//  \ /   / \ .
//   0---+   |     Two triangles that share vertex 0 only.
//        \ /
//         4
TEST(CutReport, APinchedVertexComesApart) {
  expect_cut(unit_tetrahedron_corners({{0, 1, 2}, {0, 3, 4}}), {1, 0, 2, 0, 0});
}

TEST(CutReport, OppositeOrientationsAreTurnedRoundAndBack) {
  // Both run along 0-1 in the same direction.
  expect_cut(unit_tetrahedron_corners({{0, 1, 2}, {0, 1, 3}}), {0, 1, 1, 0, 1});
}

TEST(CutReport, HalfOfAGridReversed) {
  const MadeSurface m = half_reversed();
  const TexturedSurface surface(m.input);
  EXPECT_EQ(surface.cut_report().copied_vertices, 0U);
  EXPECT_EQ(surface.cut_report().reversed_triangles, m.input.triangles.size() / 2);
  EXPECT_EQ(report_manifoldness(m.input, surface).inconsistent_edges, 20U);
}

TEST(CutReport, AMobiusStripIsCutOpenAndJoinedAgain) {
  // Five triangles around: i, i+1, i+2 modulo 5.
  std::vector<Vec3> p;
  for (int i = 0; i < 5; ++i) p.push_back({std::cos(1.26 * i), std::sin(1.26 * i), 0.1 * i});
  const TexturedTriangles in = triangles(p, {{0, 1, 2}, {2, 1, 3}, {2, 3, 4}, {4, 3, 0}, {4, 0, 1}});
  const TexturedSurface surface(in);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  EXPECT_GT(surface.cut_report().copied_vertices, 0U);
  std::vector<Index> source;
  EXPECT_EQ(facts(surface.triangles(source)), facts(in));
}

TEST(CutReport, DoubleFacesComeApartEqualOrReversed) {
  for (const Corners& second : {Corners{0, 1, 2}, Corners{0, 2, 1}, Corners{1, 2, 0}}) {
    const TexturedTriangles in = unit_tetrahedron_corners({{0, 1, 2}, second});
    const TexturedSurface surface(in);
    EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
    EXPECT_EQ(surface.live_triangles(), 2U);
    std::vector<Index> source;
    const TexturedTriangles out = surface.triangles(source);
    ASSERT_EQ(out.triangles.size(), 2U);
    EXPECT_EQ(out.positions.size(), 3U);
    EXPECT_EQ(facts(out), facts(in));
  }
}

TEST(CutReport, DoubleSidedSheetsComeApart) {
  const MadeSurface front = one_chart();
  TexturedTriangles in = front.input;
  for (const auto& t : front.input.triangles) in.triangles.push_back({t[1], t[0], t[2]});
  const TexturedSurface surface(in);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  std::vector<Index> source;
  EXPECT_EQ(facts(surface.triangles(source)), facts(in));
}

TEST(CutReport, TheBookHasAPageEachAndItsSpineIsJoinedAgain) {
  const MadeSurface m = book();
  const TexturedSurface surface(m.input);
  EXPECT_EQ(report(surface.tree().mesh(NodeId::root)).components, 3U);
  EXPECT_EQ(surface.cut_report().copied_vertices, 2U * 21);
  EXPECT_EQ(report_manifoldness(m.input, surface).edges_with_three_or_more, 20U);
}

TEST(CutReport, ChartsThatTouchInAPointComeApartInTheTextureOnly) {
  const MadeSurface m = touching_charts();
  const TexturedSurface surface(m.input);
  EXPECT_EQ(surface.cut_report().copied_vertices, 0U);
  EXPECT_EQ(report(surface.tree().mesh(*surface.texture())).components, 4U);
  EXPECT_EQ(report_seams(surface).junctions, 1U);
  EXPECT_EQ(report_seams(surface).curves, 4U);
}

TEST(CutReport, TrianglesWithoutTextureAreCounted) {
  const MadeSurface m = half_without();
  const TexturedSurface surface(m.input);
  EXPECT_EQ(surface.cut_report().triangles_without_texcoords, m.input.triangles.size() / 2);
  EXPECT_EQ(report(surface.tree().mesh(*surface.texture())).faces, m.input.triangles.size() / 2);
}

class BadTriangles : public ::testing::Test {
 protected:
  BadTriangles() : in(unit_tetrahedron_corners({{0, 1, 2}, {2, 1, 3}})) { in.texcoords = {{0, 0}, {1, 1}}; }
  std::string refusal() const {
    try {
      const TexturedSurface surface(in);
    } catch (const InputError& e) {
      return e.what();
    }
    return {};
  }
  TexturedTriangles in;
};

TEST_F(BadTriangles, PositionOutOfRange) {
  for (const std::int32_t bad : {-1, 5, INT32_MAX, INT32_MIN}) {
    in.triangles[1][2].position = bad;
    EXPECT_NE(refusal().find("triangle 1"), std::string::npos) << bad;
  }
}

TEST_F(BadTriangles, TexcoordOutOfRange) {
  for (auto& c : in.triangles[1]) c.texcoord = 0;
  in.triangles[1][0].texcoord = 2;
  EXPECT_NE(refusal().find("triangle 1"), std::string::npos);
}

TEST_F(BadTriangles, TexcoordsOnSomeCornersOnly) {
  in.triangles[1][1].texcoord = 0;
  EXPECT_NE(refusal().find("triangle 1"), std::string::npos);
  in.triangles[1][2].texcoord = 1;
  EXPECT_NE(refusal().find("triangle 1"), std::string::npos);
}

TEST_F(BadTriangles, RepeatedVertex) {
  in.triangles[1][2].position = in.triangles[1][0].position;
  const std::string message = refusal();
  EXPECT_FALSE(message.empty());
  EXPECT_NE(message.find('1'), std::string::npos) << message;
}

TEST_F(BadTriangles, None) {
  in.triangles.clear();
  EXPECT_FALSE(refusal().empty());
}

}  // namespace
}  // namespace multimesh::test
