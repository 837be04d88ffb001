// SPDX-License-Identifier: BSD-3-Clause
// Operations on small trees drawn by hand; every facet is written out.
#include <gtest/gtest.h>

#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"

namespace multimesh::test {
namespace {

using Facets = std::vector<std::vector<Index>>;

void expect_valid(const Tree& t) {
  EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
}

Facets facets(const Tree& t, NodeId n) {
  return sorted_facets(t.tree->mesh(n));
}

//         3---0---4           patch: the triangles 0 and 2; whole: all of them; cut: the second one apart
//          \ / \ /
//           1---2
struct ThreeChildren {
  Tree t = two_neighbors();
  NodeId whole = add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {3, 1, 0}, {0, 2, 4}}), {0, 1, 2, 3, 4});
  NodeId patch = add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {0, 2, 3}}), {0, 1, 2, 4});
  NodeId cut = add_cut_on_edge01(t, NodeId::root);
};

TEST(SplitSurfaces, ReplacesEveryCopyOfTheEdge) {
  ThreeChildren c;
  ASSERT_TRUE(c.t.operations->split(NodeId::root, edge(c.t, NodeId::root, 0, 1)));
  expect_valid(c.t);
  EXPECT_EQ(facets(c.t, NodeId::root), (Facets{{0, 2, 4}, {0, 2, 5}, {0, 3, 5}, {1, 2, 5}, {1, 3, 5}}));
  EXPECT_EQ(facets(c.t, c.whole), facets(c.t, NodeId::root));
  EXPECT_EQ(facets(c.t, c.patch), (Facets{{0, 2, 3}, {0, 2, 4}, {1, 2, 4}}));
  const Facets cut = facets(c.t, c.cut);
  EXPECT_EQ(cut.size(), 5U);
  EXPECT_EQ(c.t.operations->copies().of(c.cut).size(), 2U);

  ASSERT_TRUE(c.t.operations->split(c.patch, edge(c.t, c.patch, 0, 4)));
  expect_valid(c.t);
  EXPECT_EQ(facets(c.t, NodeId::root),
            (Facets{{0, 2, 4}, {0, 2, 6}, {0, 3, 6}, {1, 2, 5}, {1, 3, 5}, {2, 5, 6}, {3, 5, 6}}));
  EXPECT_EQ(facets(c.t, c.whole), facets(c.t, NodeId::root));
  EXPECT_EQ(facets(c.t, c.cut).size(), 7U);
}

TEST(CollapseSurfaces, RemovesTheFacetInEveryMesh) {
  ThreeChildren c;
  // Vertex 1 is the end of the seam 0-1: it keeps its place.
  ASSERT_TRUE(c.t.operations->collapse(NodeId::root, edge(c.t, NodeId::root, 1, 2)));
  expect_valid(c.t);
  EXPECT_EQ(facets(c.t, NodeId::root), (Facets{{0, 1, 3}, {0, 1, 4}}));
  EXPECT_EQ(facets(c.t, c.whole), facets(c.t, NodeId::root));
  EXPECT_EQ(facets(c.t, c.patch), (Facets{{0, 1, 3}}));
  EXPECT_EQ(facets(c.t, c.cut), (Facets{{0, 1, 4}, {3, 5, 6}}));
}

// In the cut child the second triangle stands alone: it cannot lose an edge.
TEST(CollapseSurfaces, IsRefusedWhereAChildWouldLoseItsLastTriangle) {
  ThreeChildren c;
  const Outcome o = c.t.operations->collapse(NodeId::root, edge(c.t, NodeId::root, 3, 1));
  ASSERT_FALSE(o);
  EXPECT_EQ(o.refusal.check, Check::link_condition);
  EXPECT_EQ(o.refusal.node, c.cut);
}

TEST(CollapseSurfaces, IsJudgedInEveryChild) {
  Tree t = two_neighbors_plus_one();
  //      1---2      the fan around 0 without its last triangle: 0 lies on the rim
  //      | \ | \    (3,0,4) is not in the child
  //      3---0---4
  const NodeId fan =
      add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {3, 1, 0}, {0, 2, 4}}), {0, 1, 2, 3, 4});
  EXPECT_TRUE(t.tree->mesh(NodeId::root).link_condition(edge(t, NodeId::root, 0, 2)));
  const CollapseVerdict inside = t.operations->judge(NodeId::root, edge(t, NodeId::root, 0, 2));
  EXPECT_EQ(inside.refusal.check, Check::link_condition);
  EXPECT_EQ(inside.refusal.node, fan);
  EXPECT_FALSE(t.operations->judge(NodeId::root, edge(t, NodeId::root, 1, 2)).refusal.refused());
  ASSERT_TRUE(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 1, 2)));
  expect_valid(t);
}

//      0---1      line: the diagonal 1-3
//      | / |      two: the sides 0-1 and, apart from it, the diagonal 3-1
//      3---2
TEST(SplitCurve, FollowsTheSplitOfASurface) {
  Tree t = drawn({{0, 3, 1}, {1, 3, 2}});
  const NodeId line = add_drawn(t, NodeId::root, segments({{0, 1}}), {1, 3});
  const NodeId two = add_drawn(t, NodeId::root, segments({{0, 1}, {2, 3}}), {0, 1, 3, 1});
  ASSERT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 1, 3)));
  expect_valid(t);
  EXPECT_EQ(facets(t, line), (Facets{{0, 2}, {1, 2}}));
  EXPECT_EQ(facets(t, two), (Facets{{0, 1}, {2, 4}, {3, 4}}));
  ASSERT_TRUE(t.operations->split(line, edge(t, line, 0, 2)));
  expect_valid(t);
  EXPECT_EQ(facets(t, line).size(), 3U);
  EXPECT_EQ(facets(t, two).size(), 4U);
  EXPECT_EQ(facets(t, NodeId::root).size(), 6U);
}

//      2
//     / \      The edge 0-1 is the child. Splitting another edge moves its anchor to the half that
//    0===1     contains it.
TEST(SplitCurve, MovesTheAnchorToTheHalfThatContainsIt) {
  for (const Segment other : {Segment{0, 2}, Segment{2, 0}, Segment{1, 2}, Segment{2, 1}}) {
    Tree t = drawn({{0, 1, 2}});
    const NodeId line = add_drawn(t, NodeId::root, segments({{0, 1}}), {0, 1});
    ASSERT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, other[0], other[1])));
    expect_valid(t);
    const Dart up = t.tree->to_parent(line, edge(t, line, 0, 1));
    EXPECT_EQ(t.tree->mesh(NodeId::root).simplex(up, 1),
              t.tree->mesh(NodeId::root).simplex(edge(t, NodeId::root, 0, 1), 1));
  }
}

// two_neighbors with the edge 0-4 as child: collapses elsewhere, and of the edge next to it.
TEST(CollapseCurve, KeepsTheAnchorOfAnEdgeBesideTheCollapse) {
  for (const Segment e : {Segment{3, 1}, Segment{1, 3}, Segment{2, 4}, Segment{4, 2}, Segment{1, 2}}) {
    Tree t = two_neighbors();
    const NodeId line = add_drawn(t, NodeId::root, segments({{0, 1}}), {0, 4});
    SCOPED_TRACE(testing::Message() << e[0] << "-" << e[1]);
    ASSERT_TRUE(t.operations->collapse(NodeId::root, edge(t, NodeId::root, e[0], e[1])));
    expect_valid(t);
    EXPECT_EQ(facets(t, line).size(), 1U);
    EXPECT_EQ(facets(t, NodeId::root).size(), 2U);
  }
}

TEST(CollapseCurve, IsRefusedOnItsLastEdge) {
  Tree t = two_neighbors();
  const NodeId line = add_drawn(t, NodeId::root, segments({{0, 1}}), {0, 4});
  for (const auto& [n, e] :
       {std::pair{NodeId::root, edge(t, NodeId::root, 0, 4)}, {line, edge(t, line, 1, 0)}}) {
    const Outcome o = t.operations->collapse(n, e);
    EXPECT_EQ(o.refusal.check, Check::link_condition);
    EXPECT_EQ(o.refusal.node, line);
  }
}

// The edges 0-1 and 0-2 are a curve: the collapse of 1-2 would fold one on the other, that of 3-1 does not.
//         3---0---4
//          \ // \\ /
//           1---2
TEST(CollapseCurve, IsRefusedWhereItWouldFoldTheCurve) {
  Tree t = two_neighbors();
  (void)add_drawn(t, NodeId::root, segments({{0, 1}, {2, 0}}), {0, 1, 2});
  EXPECT_EQ(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 1, 2)).refusal.check, Check::gluing);
  EXPECT_EQ(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 3, 1)).refusal.check, Check::none);
}

TEST(DiskToIndividual, SplitsOnEverythingAndStaysValid) {
  Tree t = disk_to_individual(5);
  for (int round = 0; round < 2; ++round) {
    for (const NodeId n : {NodeId::root, NodeId{1}})
      for (Index e = 0; e < 10; ++e)
        if (const Dart d = t.tree->mesh(n).dart_of(1, e); d != no_dart) {
          ASSERT_TRUE(t.operations->split(n, d));
          expect_valid(t);
        }
    EXPECT_EQ(facets(t, NodeId{1}).size(), facets(t, NodeId::root).size());
    t.tree->compact();
    expect_valid(t);
  }
}

// The fan, its triangles one by one, and below them the edges of their boundary: depth 2, dimension 1.
TEST(DiskToIndividual, HasEveryEdgeOfEveryTriangleAsGrandchild) {
  const Index n = 20;
  Tree t = disk_to_individual(n);
  const NodeId rims = t.add_boundary(NodeId{1});
  expect_valid(t);
  EXPECT_EQ(facets(t, rims).size(), 3U * n);
  const Mesh& root = t.tree->mesh(NodeId::root);
  for (const Dart e : simplices_of(root, 1)) {
    DartBuffer found;
    t.tree->to_descendant(NodeId::root, e, 1, rims, found);
    EXPECT_EQ(found.size(), root.is_boundary(e, 1) ? 1U : 2U);
  }
  for (const Dart e : simplices_of(t.tree->mesh(rims), 1))
    EXPECT_TRUE(t.tree->mesh(NodeId{1}).is_boundary(t.tree->to_parent(rims, e), 1));
  ASSERT_TRUE(t.operations->split(rims, t.tree->mesh(rims).dart_of(1, 0)));
  expect_valid(t);
}

}  // namespace
}  // namespace multimesh::test
