// SPDX-License-Identifier: BSD-3-Clause
// Normals: hard edges from those of a file, kept by the tree, and normals computed anew from them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/domains/corner_normals.hpp"
#include "multimesh/domains/shading.hpp"
#include "multimesh/operations.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

constexpr double degrees = std::numbers::pi / 180;

const Vec3& position(const TexturedTriangles& s, std::size_t t, std::size_t i) {
  return s.positions[static_cast<std::size_t>(s.triangles[t][i].position)];
}

Vec3 face_normal(const TexturedTriangles& s, std::size_t t) {
  const Vec3& p = position(s, t, 0);
  return cross(position(s, t, 1) - p, position(s, t, 2) - p).normalized();
}

double angle(const Vec3& m, const Vec3& n) {
  return std::atan2(cross(m, n).norm(), dot(m, n)) / degrees;
}

/// Gives a surface the normals that `normal` says, a list entry per corner.
using NormalOf = std::function<Vec3(std::size_t triangle, std::size_t corner)>;
TexturedTriangles shaded(TexturedTriangles s, const NormalOf& normal) {
  std::vector<Vec3> normals;
  std::vector<std::array<std::int32_t, 3>> corners(s.triangles.size());
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      corners[t][i] = static_cast<std::int32_t>(normals.size());
      normals.push_back(normal(t, i));
    }
  s.shading = shading(s, normals, corners);
  return s;
}

TexturedTriangles flat(const TexturedTriangles& s) {
  return shaded(s, [&](std::size_t t, std::size_t) { return face_normal(s, t); });
}
TexturedTriangles round(const TexturedTriangles& s) {
  return shaded(s, [&](std::size_t t, std::size_t i) { return position(s, t, i); });
}

TexturedTriangles cube() {
  TexturedTriangles s;
  for (int i = 0; i < 8; ++i) s.positions.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& q : quads) {
    s.triangles.push_back({{{q[0]}, {q[1]}, {q[2]}}});
    s.triangles.push_back({{{q[0]}, {q[2]}, {q[3]}}});
  }
  return s;
}

std::size_t hard_edges_of(const TexturedSurface& surface) {
  const Mesh& root = surface.tree().mesh(NodeId::root);
  std::size_t n = 0;
  for (Index e = 0; e < root.capacity(1); ++e) n += root.is_live(1, e) && surface.hard(e);
  return n;
}

/// Hard edges by their positions, each once.
std::set<std::array<Vec3, 2>> hard_edges_of(const TexturedTriangles& s) {
  std::set<std::array<Vec3, 2>> edges;
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (s.shading[t] >> i & 1U)
        edges.insert({std::min(position(s, t, i), position(s, t, (i + 1) % 3)),
                      std::max(position(s, t, i), position(s, t, (i + 1) % 3))});
  return edges;
}

/// Expects the surface's normals to be within an angle in degrees of what is expected corner by corner.
void expect_normals(const TexturedSurface& surface, double tolerance,
                    const std::function<Vec3(const TexturedTriangles&, std::size_t, std::size_t)>& expected) {
  std::vector<Index> source;
  const TexturedTriangles out = surface.triangles(source);
  const CornerNormals n = corner_normals(surface);
  ASSERT_EQ(n.corners.size(), out.triangles.size());
  for (std::size_t t = 0; t < out.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& have = n.normals[static_cast<std::size_t>(n.corners[t][i])];
      ASSERT_LE(angle(have, expected(out, t, i)), tolerance) << "triangle " << t << " corner " << i;
      ASSERT_NEAR(have.norm(), 1, 2e-6);
    }
}
const auto of_the_face = [](const TexturedTriangles& s, std::size_t t, std::size_t) {
  return face_normal(s, t);
};

TEST(Shading, AFlatCubeHasTwelveHardEdgesAndSixNormals) {
  const TexturedTriangles in = flat(cube());
  const TexturedSurface surface(in);
  ASSERT_TRUE(surface.has_normals());
  EXPECT_EQ(hard_edges_of(surface), 12U);
  EXPECT_EQ(corner_normals(surface).normals.size(), 6U);
  expect_normals(surface, 1e-4, of_the_face);
}

TEST(Shading, ASmoothCubeHasNoneAndEightNormals) {
  const TexturedTriangles in = shaded(
      cube(), [s = cube()](std::size_t t, std::size_t i) { return position(s, t, i) - Vec3(.5, .5, .5); });
  const TexturedSurface surface(in);
  ASSERT_TRUE(surface.has_normals());
  EXPECT_EQ(hard_edges_of(surface), 0U);
  EXPECT_EQ(corner_normals(surface).normals.size(), 8U);
  expect_normals(surface, 1e-4, [](const TexturedTriangles& s, std::size_t t, std::size_t i) {
    return position(s, t, i) - Vec3(.5, .5, .5);  // by angles: a diagonal of a side does not matter
  });
}

TEST(Shading, ASmoothSphereStaysSmooth) {
  const TexturedSurface surface(round(bare(sphere(5))));
  EXPECT_EQ(hard_edges_of(surface), 0U);
  expect_normals(surface, 1, &position);
}

TEST(Shading, HalfFlatHalfSmooth) {
  const TexturedTriangles s = bare(sphere(4));
  const auto is_flat = [](const TexturedTriangles& x, std::size_t t) {
    return position(x, t, 0)[2] + position(x, t, 1)[2] + position(x, t, 2)[2] > 0;
  };
  const TexturedSurface surface(shaded(s, [&](std::size_t t, std::size_t i) {
    return is_flat(s, t) ? face_normal(s, t) : position(s, t, i);
  }));
  const Mesh& root = surface.tree().mesh(NodeId::root);
  for (Index e = 0; e < root.capacity(1); ++e) {
    const Dart d = root.dart_of(1, e);
    const Index f = root.facet(d), g = root.facet(root.switch_dart(d, 2));
    // Some neighbours lie in one plane.
    const bool coplanar = angle(face_normal(s, f), face_normal(s, g)) < 0.5;
    const bool both = is_flat(s, f) && is_flat(s, g);
    EXPECT_EQ(surface.hard(e), both ? !coplanar : is_flat(s, f) || is_flat(s, g));
  }
  // At the border the smooth half's fans have half of the faces only.
  expect_normals(surface, 6, [&](const TexturedTriangles& x, std::size_t t, std::size_t i) {
    return is_flat(x, t) ? face_normal(x, t) : position(x, t, i);
  });
}

TEST(Shading, RoundTripKeepsTheHardEdges) {
  for (const MadeSurface& made : made_surfaces()) {
    const TexturedTriangles in = flat(made.input);
    const TexturedSurface surface(in);
    std::vector<Index> source;
    const TexturedTriangles out = surface.triangles(source);
    ASSERT_EQ(out.shading.size(), out.triangles.size());
    std::set<std::array<Vec3, 2>> missing = hard_edges_of(in);
    for (const auto& e : hard_edges_of(out)) EXPECT_EQ(missing.erase(e), 1U) << made.name;
    EXPECT_TRUE(missing.empty()) << made.name;
    expect_normals(surface, 0.5, of_the_face);
  }
}

TEST(Shading, WithoutNormalsThereIsNone) {
  const TexturedSurface surface(cube());
  EXPECT_FALSE(surface.has_normals());
  std::vector<Index> source;
  EXPECT_TRUE(surface.triangles(source).shading.empty());
  EXPECT_EQ(corner_normals(surface).normals.size(), 8U) << "all edges are smooth";
}

TEST(Shading, SmallDifferencesAndMissingNormalsAreSmooth) {
  TexturedTriangles s;
  s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  s.triangles = {{{{0}, {1}, {2}}}, {{{0}, {2}, {3}}}};
  const auto bits = [&](double turn, std::int32_t missing) {
    const std::vector<Vec3> normals{
        {0, 0, 2}, {0, std::sin(turn * degrees), std::cos(turn * degrees)}, {0, 0, 0}};
    return shading(s, normals, std::vector<std::array<std::int32_t, 3>>{{0, 0, 0}, {missing, missing, 1}})[0];
  };
  EXPECT_EQ(bits(0.4, 1), flat_shaded);
  EXPECT_EQ(bits(0.6, 1), flat_shaded | 4) << "the edge from corner 2 to corner 0";
  EXPECT_EQ(bits(90, -1), flat_shaded) << "no normal";
  EXPECT_EQ(bits(90, 2), flat_shaded) << "a normal of no length";
}

TEST(Shading, NormalsStayOnTheirSide) {
  const TexturedTriangles s = cube();
  const TexturedSurface inward(shaded(s, [&](std::size_t t, std::size_t) { return -face_normal(s, t); }));
  expect_normals(inward, 1e-4,
                 [](const TexturedTriangles& x, std::size_t t, std::size_t) { return -face_normal(x, t); });
  // Triangles turned round, normals all the same: they stay the same.
  const TexturedTriangles half = half_reversed().input;
  const TexturedSurface surface(shaded(half, [](std::size_t, std::size_t) { return Vec3(0, 0, 1); }));
  ASSERT_GT(surface.cut_report().reversed_triangles, 0U);
  EXPECT_EQ(hard_edges_of(surface), 0U);
  expect_normals(surface, 1e-4,
                 [](const TexturedTriangles&, std::size_t, std::size_t) { return Vec3(0, 0, 1); });
}

TEST(Shading, AHardEdgeThatReachesTheBoundaryDividesItsFan) {
  TexturedTriangles roof = bare(grid(4, 4));
  for (auto& p : roof.positions) p[2] = -std::abs(p[0] - 2);
  const TexturedSurface surface(flat(roof));
  EXPECT_EQ(hard_edges_of(surface), 4U);
  EXPECT_EQ(corner_normals(surface).normals.size(), 2U);
  expect_normals(surface, 1e-4, of_the_face);
}

TEST(Shading, FacesWithoutAreaHaveANormal) {
  TexturedTriangles s;
  s.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  s.triangles = {{{{0}, {1}, {2}}}};
  EXPECT_EQ(corner_normals(TexturedSurface(s)).normals, (std::vector<Vec3>{{0, 0, 1}}));
}

TEST(Shading, ADecimatedFlatSurfaceIsFlat) {
  TexturedSurface surface(flat(bare(sphere(4))));
  DecimateOptions options;
  options.faces = 200;
  (void)decimate(surface, options);
  expect_normals(surface, 5, of_the_face);
}

TEST(HardEdges, WinWhereTwoEdgesBecomeOne) {
  const TexturedTriangles smooth = round(bare(sphere(3)));
  for (const Placement& placement : {Placement::keep_a(), Placement::keep_b()})
    for (int which = 0; which < 4; ++which) {
      TexturedSurface surface(smooth);
      const Mesh& root = surface.tree().mesh(NodeId::root);
      const Dart e = root.dart_of(1, 17);
      const Dart side = which < 2 ? e : root.switch_dart(e, 2);
      const Dart at_end = which % 2 == 0 ? side : root.switch_dart(side, 0);
      surface.set_hard(root.simplex(root.switch_dart(at_end, 1), 1));
      const Embedding embedding = surface.embedding();
      ASSERT_TRUE(EmbeddedMesh(embedding, NodeId::root).operations().collapse(NodeId::root, e, placement));
      EXPECT_EQ(hard_edges_of(surface), 1U) << which;
    }
}

TEST(HardEdges, AtTheBoundaryOnePairBecomesOne) {
  TexturedSurface surface(flat(bare(grid(4, 4))));
  const Mesh& root = surface.tree().mesh(NodeId::root);
  Index edge = 0;
  while (!root.is_boundary(root.dart_of(1, edge), 1)) ++edge;
  const Dart e = root.dart_of(1, edge);
  surface.set_hard(root.simplex(root.switch_dart(e, 1), 1));
  const Embedding embedding = surface.embedding();
  ASSERT_TRUE(EmbeddedMesh(embedding, NodeId::root).operations().collapse(NodeId::root, e));
  EXPECT_EQ(hard_edges_of(surface), 1U);
}

}  // namespace
}  // namespace multimesh::test
