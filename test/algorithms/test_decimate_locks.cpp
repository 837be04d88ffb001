// SPDX-License-Identifier: BSD-3-Clause
// What decimate() must leave unchanged: boundaries, seams, borders of labels, sharp edges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/decimate_cost_name.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

/// One side of an edge, by values: two positions, two texture coordinates (0 0 where there are none), the one
/// of the lower end first.
using Side = std::array<double, 10>;

Side side_of(const TexturedTriangles& s, std::size_t t, std::size_t i, bool with_texture) {
  std::array<std::array<double, 5>, 2> ends{};
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& c = s.triangles[t][(i + k) % 3];
    const Vec3& p = s.positions[static_cast<std::size_t>(c.position)];
    const bool has = with_texture && c.texcoord >= 0;
    const Vec2 uv = has ? s.texcoords[static_cast<std::size_t>(c.texcoord)] : Vec2(0, 0);
    ends[k] = {p[0], p[1], p[2], uv[0], uv[1]};
  }
  std::sort(ends.begin(), ends.end());
  Side side{};
  std::copy(ends[0].begin(), ends[0].end(), side.begin());
  std::copy(ends[1].begin(), ends[1].end(), side.begin() + 5);
  return side;
}

/// All sides of edges by the edge's positions.
std::map<Side, std::vector<Side>> sides_by_edge(const TexturedTriangles& s) {
  std::map<Side, std::vector<Side>> sides;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) sides[side_of(s, t, i, false)].push_back(side_of(s, t, i, true));
  return sides;
}

std::multiset<Side> boundary_of(const TexturedTriangles& s) {
  std::multiset<Side> boundary;
  for (const auto& [edge, sides] : sides_by_edge(s))
    if (sides.size() == 1) boundary.insert(sides[0]);
  return boundary;
}

/// Both sides of each edge that has two which differ; triangles without texture coordinates have no seams.
std::multiset<Side> seams_of(TexturedTriangles s) {
  std::erase_if(s.triangles, [](const auto& t) { return t[0].texcoord < 0; });
  std::multiset<Side> seams;
  for (const auto& [edge, sides] : sides_by_edge(s))
    if (sides.size() == 2 && sides[0] != sides[1]) seams.insert(sides.begin(), sides.end());
  return seams;
}

DecimateOptions to_faces(std::size_t faces) {
  DecimateOptions o;
  o.faces = faces;
  return o;
}

TexturedTriangles left_of(const TexturedSurface& surface) {
  std::vector<Index> source;
  return surface.triangles(source);
}

std::size_t locked_vertices(const TexturedSurface& surface) {
  const Mesh& root = surface.tree().mesh(NodeId::root);
  std::size_t n = 0;
  for (Index v = 0; v < root.capacity(0); ++v) n += root.is_live(0, v) && root.is_locked(v);
  return n;
}

class Locks : public ::testing::TestWithParam<MadeSurface> {};

TEST_P(Locks, TheBoundaryStays) {
  TexturedSurface surface(GetParam().input);
  const std::multiset<Side> before = boundary_of(left_of(surface));
  DecimateOptions options = to_faces(1);
  options.lock_boundary = true;
  const DecimateResult r = decimate(surface, options);
  EXPECT_GT(r.collapsed, 0U);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  EXPECT_EQ(boundary_of(left_of(surface)), before);
}

TEST_P(Locks, SeamsStay) {
  TexturedSurface surface(GetParam().input);
  const std::multiset<Side> before = seams_of(left_of(surface));
  DecimateOptions options = to_faces(1);
  options.lock_seams = true;
  const DecimateResult r = decimate(surface, options);
  EXPECT_GT(r.collapsed, 0U);
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  EXPECT_EQ(seams_of(left_of(surface)), before);
}

TEST_P(Locks, AreTakenAwayAfterTheRun) {
  TexturedSurface surface(GetParam().input);
  DecimateOptions options = to_faces(1);
  options.lock_boundary = options.lock_seams = true;
  (void)decimate(surface, options);
  const Mesh& root = surface.tree().mesh(NodeId::root);
  for (Index v = 0; v < root.capacity(0); ++v)
    ASSERT_TRUE(!root.is_live(0, v) || root.is_locked(v) == surface.is_copy(v)) << "vertex " << v;
  const TexturedTriangles locked = left_of(surface);
  const bool has_any = !boundary_of(locked).empty() || !seams_of(locked).empty();
  const DecimateResult free = decimate(surface, to_faces(1));
  if (has_any) {
    EXPECT_LT(free.faces_after, locked.triangles.size()) << "a second run may move them";
  }
}

INSTANTIATE_TEST_SUITE_P(Made, Locks, ::testing::ValuesIn(made_surfaces()),
                         [](const auto& p) { return p.param.name; });

TEST(Locks, AreTakenAwayWhenARunIsAbandoned) {
  TexturedSurface surface(two_charts().input);
  DecimateOptions options = to_faces(1);
  options.levels = {790};
  options.lock_boundary = options.lock_seams = true;
  options.on_level = [](std::size_t) { throw std::runtime_error("enough"); };
  EXPECT_THROW(decimate(surface, options), std::runtime_error);
  EXPECT_EQ(locked_vertices(surface), 0U);
}

TEST(Locks, OfTheCallerStay) {
  TexturedSurface surface(one_chart().input);
  const Index middle = 10 * 21 + 10, corner = 0;
  const Vec3 place = surface.positions()[middle];
  surface.set_locked(middle, true);
  surface.set_locked(corner, true);
  DecimateOptions options = to_faces(1);
  options.lock_boundary = true;
  (void)decimate(surface, options);
  (void)decimate(surface, to_faces(1));
  EXPECT_EQ(locked_vertices(surface), 2U);
  EXPECT_EQ(surface.positions()[middle], place);
  EXPECT_TRUE(surface.tree().mesh(NodeId::root).is_locked(middle));
  EXPECT_TRUE(surface.tree().mesh(NodeId::root).is_locked(corner));
}

TEST(Locks, SeamsOfEachSetStay) {
  TexturedTriangles in = waves();
  add_uv_set(in, [&](std::size_t t, const Vec3& p) {
    return Vec2(p[0] + (centroid(in, t)[1] < 10 ? 0 : 100), p[1]);
  });
  TexturedSurface surface(in);
  const TexturedTriangles before = left_of(surface);
  DecimateOptions options = to_faces(1);
  options.lock_seams = true;
  ASSERT_GT(decimate(surface, options).collapsed, 0U);
  for (const std::size_t set : {0, 1}) {
    const std::multiset<Side> seams = seams_of(only_uv_set(before, set));
    EXPECT_EQ(seams.size(), 40U);
    EXPECT_EQ(seams_of(only_uv_set(left_of(surface), set)), seams);
  }
}

TEST(LabelBorders, ArePreservedUnlessTheyAreNot) {
  TexturedTriangles in = waves();
  for (std::size_t t = 0; t < in.triangles.size(); ++t)
    in.labels.push_back(centroid(in, t)[1] < 10 ? 5U : 9U);
  TexturedSurface kept(in), loose(in, {.keep_label_borders = false});
  const CurveReport before = report_curves(kept, label_border_curve);
  EXPECT_EQ(before.curves, 1U);
  (void)decimate(kept, to_faces(40));
  (void)decimate(loose, to_faces(40));
  const CurveReport after = report_curves(kept, label_border_curve);
  EXPECT_EQ(after.curves, 1U);
  EXPECT_EQ(after.ends, 2U);
  EXPECT_LT(after.edges, before.edges);
  EXPECT_EQ(report_curves(loose, label_border_curve).edges, 0U);
  // Where labels meet, by the labels that triangles have: ends of the border are where they were.
  const auto ends = [&](const TexturedSurface& surface) {
    std::vector<Index> source;
    const TexturedTriangles out = surface.triangles(source);
    std::map<Side, std::set<Index>> labels;
    for (std::size_t t = 0; t < source.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) labels[side_of(out, t, i, false)].insert(in.labels[source[t]]);
    std::map<std::array<double, 2>, int> degree;
    for (const auto& [edge, found] : labels)
      if (found.size() == 2) ++degree[{edge[0], edge[1]}], ++degree[{edge[5], edge[6]}];
    std::set<std::array<double, 2>> result;
    for (const auto& [place, n] : degree)
      if (n == 1) result.insert(place);
    return result;
  };
  const std::set<std::array<double, 2>> sides{{0, 10}, {20, 10}};
  EXPECT_EQ(ends(kept), sides);
  EXPECT_NE(ends(loose), sides);
}

enum class Texture { none, faces, cross };

void PrintTo(Texture t, std::ostream* out) {
  *out << (t == Texture::none ? "no texture" : t == Texture::faces ? "a chart per side" : "a cross");
}

class Cube : public ::testing::TestWithParam<std::tuple<Texture, double, DecimateCost>> {
 protected:
  static constexpr int n = 10;
};

/// In how many of its coordinates a point lies on the cube's surface: 1 in faces, 2 on edges, 3 at corners.
int sides_at(const Vec3& p, int n, double tolerance) {
  int count = 0;
  for (int i = 0; i < 3; ++i) count += std::abs(p[i]) <= tolerance || std::abs(p[i] - n) <= tolerance;
  return count;
}

TEST_P(Cube, KeepsItsEdgesAsCurvesAndItsCornersExactly) {
  const auto [texture, ratio, cost] = GetParam();
  TexturedTriangles in = cube(n);
  if (texture == Texture::faces) unwrap_to_faces(in, n);
  if (texture == Texture::cross) unwrap_to_cross(in, n);
  TexturedSurface surface(in, {.feature_angle = 80 * std::numbers::pi / 180});
  ASSERT_EQ(surface.cut_report().reversed_triangles, 0U);
  DecimateOptions options = to_faces(std::max<std::size_t>(1, static_cast<std::size_t>(ratio * 12 * n * n)));
  options.cost = cost;
  const DecimateResult r = decimate(surface, options);
  if (ratio < 0.01) {
    EXPECT_EQ(r.faces_after, 12U) << "nothing is left but the cube";
  } else {
    EXPECT_EQ(r.stop, DecimateResult::Stop::faces);
  }
  const CurveReport edges = report_features(surface);
  EXPECT_EQ(edges.curves, 12U);
  EXPECT_EQ(edges.junctions, 8U);
  EXPECT_EQ(edges.ends, 0U);
  const Mesh& root = surface.tree().mesh(NodeId::root);
  std::size_t corners = 0;
  for (Index v = 0; v < root.capacity(0); ++v) {
    if (!root.is_live(0, v)) continue;
    corners += sides_at(surface.positions()[v], n, 0) == 3;
    EXPECT_GE(sides_at(surface.positions()[v], n, 1e-6), 1) << "vertices stay in faces";
  }
  EXPECT_EQ(corners, 8U);
  for (Index e = 0; e < root.capacity(1); ++e) {
    if (!root.is_live(1, e)) continue;
    const Dart d = root.dart_of(1, e);
    if (!(surface.curve_kinds(d) & sharp_curve)) continue;
    const Vec3& p = surface.positions()[root.vertex(d)];
    const Vec3& q = surface.positions()[root.vertex(root.switch_dart(d, 0))];
    EXPECT_GE(sides_at(p, n, 1e-6), 2);
    EXPECT_GE(sides_at((p + q) * 0.5, n, 1e-6), 2) << "curves run along the cube's edges";
  }
  const TexturedTriangles out = left_of(surface);
  EXPECT_EQ(facts(out), facts(in));
}

INSTANTIATE_TEST_SUITE_P(FeatureAngle, Cube,
                         ::testing::Combine(::testing::Values(Texture::none, Texture::faces, Texture::cross),
                                            ::testing::Values(0.5, 0.1, 0.03, 0.001),
                                            ::testing::Values(DecimateCost::quadric, DecimateCost::length)));

TEST(Cube, IsRoundedWithoutAFeatureAngle) {
  TexturedSurface surface(cube(10));
  DecimateOptions options = to_faces(40);
  options.cost = DecimateCost::length;
  (void)decimate(surface, options);
  std::size_t corners = 0;
  const Mesh& root = surface.tree().mesh(NodeId::root);
  for (Index v = 0; v < root.capacity(0); ++v)
    corners += root.is_live(0, v) && sides_at(surface.positions()[v], 10, 0) == 3;
  EXPECT_LT(corners, 8U) << "the test above says something";
}

}  // namespace
}  // namespace multimesh::test
