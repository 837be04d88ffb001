// SPDX-License-Identifier: BSD-3-Clause
// The exact sign of facets in coordinates: of charts, mirrored ones included, in random operations.
#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/keeps_orientation.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

__extension__ using Quad = __float128;

/// Two square charts, jittered: one on the right, and its mirror image on the left.
Shape two_charts(std::mt19937& random) {
  Shape s = grid(6, 6);
  const auto n = static_cast<Index>(s.points.size());
  std::uniform_real_distribution<double> jitter(-0.04, 0.04);
  for (Point& p : s.points) p = {1 + p[0] + jitter(random), p[1] + jitter(random), 0};
  for (Index v = 0; v < n; ++v) s.points.push_back({-s.points[v][0], s.points[v][1], 0});
  const std::vector<Index> corners = s.facets.corners;
  for (const Index v : corners) s.facets.corners.push_back(n + v);
  s.facets.vertices = 2 * n;
  return s;
}

/// Exact enough: differences of these doubles and their products have fewer than 113 digits.
int sign(const Tree& t, Index facet) {
  const Mesh& mesh = t.tree->mesh(NodeId::root);
  Index v[4];
  mesh.facet_vertices(facet, v);
  const auto& p = t.points(NodeId::root);
  const Vec3 &a = p[v[0]], &b = p[v[1]], &c = p[v[2]];
  const Quad det = (Quad(b[0]) - a[0]) * (Quad(c[1]) - a[1]) - (Quad(b[1]) - a[1]) * (Quad(c[0]) - a[0]);
  return (det > 0) - (det < 0);
}

/// Triangles by their corners.
Shape drawn(std::vector<Index> corners, std::vector<Point> points) {
  Shape s;
  s.facets.vertices = static_cast<Index>(points.size());
  s.facets.corners = std::move(corners);
  s.points = std::move(points);
  return s;
}

TEST(KeepsOrientation, NoTriangleOfAMirroredChartFlips) {
  for (unsigned seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    Tree t(two_charts(random));
    const Mesh& mesh = t.tree->mesh(NodeId::root);
    const int right = sign(t, 0);
    KeepsOrientation keeps(t.attribute(NodeId::root), mesh);
    t.operations->add(keeps);
    std::size_t done[3] = {}, refused = 0;
    for (int i = 0; i < 1500; ++i) {
      const auto e = static_cast<Index>(random() % mesh.capacity(1));
      if (!mesh.is_live(1, e)) continue;
      const Dart d = mesh.dart_of(1, e);
      const double at = double(random() % 5) / 4;
      const auto which = random() % 8;
      const int kind = which == 0 ? 0 : which < 4 ? 1 : 2;
      const Outcome o = kind == 0   ? t.operations->split(NodeId::root, d, 0.2 + 0.6 * at)
                        : kind == 1 ? t.operations->collapse(NodeId::root, d, Placement::at(at))
                                    : t.operations->swap(NodeId::root, d);
      done[kind] += static_cast<bool>(o);
      refused += o.refusal.check == Check::invariant;
      for (Index f = 0; f < mesh.capacity(2); ++f) {
        if (!mesh.is_live(2, f)) continue;
        Index v[4];
        mesh.facet_vertices(f, v);
        ASSERT_EQ(sign(t, f), t.points(NodeId::root)[v[0]][0] > 0 ? right : -right) << "step " << i;
      }
    }
    for (const std::size_t n : done) EXPECT_GT(n, 10U);
    EXPECT_GT(refused, 10U);
  }
}

//      2         Without area: (0,1,2) and (0,4,1), since 1 is on the line of 4, 0 and 2.
//    / |         .
//  3---0 1       .
//    \ |         .
//      4         .
TEST(KeepsOrientation, ATriangleWithoutAreaMayComeToTheSideOfAllOthers) {
  Tree t(drawn({0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1},
               {{0, 0, 0}, {0, 0.5, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}));
  const Mesh& mesh = t.tree->mesh(NodeId::root);
  KeepsOrientation keeps(t.attribute(NodeId::root), mesh);
  const Dart middle = mesh.dart_of(0, 0);
  EXPECT_TRUE(keeps.allows(mesh, middle, {-0.1, 0, 0}));
  EXPECT_FALSE(keeps.allows(mesh, middle, {0.1, 0, 0}));
  EXPECT_TRUE(keeps.allows(mesh, middle, {0, 0.1, 0}));
  EXPECT_FALSE(keeps.allows(mesh, middle, {-1, 0, 0}));  // (0,2,3) and (0,3,4) would vanish
  EXPECT_TRUE(keeps.allows(mesh, middle, {-1, 0, 0}, 3));
}

TEST(KeepsOrientation, NoTriangleThatCanBeSeenVanishes) {
  Tree t(drawn({0, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  const Mesh& mesh = t.tree->mesh(NodeId::root);
  KeepsOrientation keeps(t.attribute(NodeId::root), mesh);
  const Dart tip = mesh.dart_of(0, 2);
  EXPECT_TRUE(keeps.allows(mesh, tip, {0, 1e-6, 0}));
  EXPECT_FALSE(keeps.allows(mesh, tip, {0, 1e-14, 0}));
}

TEST(KeepsOrientation, TrianglesInSpaceStayPositiveAlongANormal) {
  Tree t(
      drawn({0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}, {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}));
  KeepsOrientation keeps(t.attribute(NodeId::root), Vec3(0, 0, 1));
  t.operations->add(keeps);
  const Dart tip = t.tree->mesh(NodeId::root).dart_of(0, 0);
  EXPECT_TRUE(t.move(NodeId::root, tip, {0.4, 0.4, -3}));
  EXPECT_EQ(t.move(NodeId::root, tip, {0.4, 0.4, 0}).refusal.check, Check::invariant);
  EXPECT_EQ(t.points(NodeId::root)[0], Vec3(0.4, 0.4, -2));
}

// Seen from 0, 3 is behind 2: (1,2,3) would flip.
TEST(KeepsOrientation, CollapsesIntoTheFirstVertexAreJudged) {
  Tree t(drawn({1, 0, 2, 1, 2, 3, 1, 3, 4, 1, 4, 5, 1, 5, 0},
               {{2, 0, 0}, {0, 0, 0}, {0.5, 0.1, 0}, {1.5, 1, 0}, {-1, 0, 0}, {0, -1, 0}}));
  const Mesh& mesh = t.tree->mesh(NodeId::root);
  DartBuffer edges;
  edges_around(mesh, mesh.dart_of(0, 1), edges);
  const Dart edge =
      *std::ranges::find_if(edges, [&](Dart d) { return mesh.vertex(mesh.reorder(d, exchange_ends)) == 0; });
  KeepsOrientation in_space(t.attribute(NodeId::root), Vec3(0, 0, 1));
  KeepsOrientation chart(t.attribute(NodeId::root), mesh);
  for (Invariant* keeps : {&in_space, &chart}) {
    Propagation operations = *t.operations;
    operations.add(*keeps);
    EXPECT_EQ(operations.collapse(NodeId::root, edge, Placement::keep_b()).refusal.check, Check::invariant);
  }
  EXPECT_TRUE(t.operations->collapse(NodeId::root, edge, Placement::keep_b()));
}

}  // namespace
}  // namespace multimesh::test
