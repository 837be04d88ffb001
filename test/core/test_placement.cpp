// SPDX-License-Identifier: BSD-3-Clause
// Where the merged vertex of a collapse goes, and which ends keep their place.
#include <gtest/gtest.h>

#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"

namespace multimesh::test {
namespace {

void lock(Tree& t, NodeId n, Index v) {
  auto& om = dynamic_cast<openmesh::Connectivity&>(t.tree->mesh(n)).openmesh();
  om.status(OpenMesh::VertexHandle(static_cast<int>(v))).set_locked(true);
}

Index merged_vertex(const Tree& t, NodeId n, const Outcome& o) {
  return t.tree->mesh(n).vertex(o.dart);
}

// 12-13-14-15    grid(3, 3), drawn with i to the right and j up: vertex 4*i + j; 5, 6, 9, 10 are interior
struct Grid {
  Tree t{grid(3, 3)};
  Outcome collapse(Index a, Index b, Placement p) {
    return t.operations->collapse(NodeId::root, edge(t, NodeId::root, a, b), p);
  }
  Point3 at(Index v) const { return t.points(NodeId::root)[v]; }
};

TEST(Placement, MixesThePositionsOfTheEnds) {
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    Grid g;
    const Point3 a = g.at(5), b = g.at(10);
    const Outcome o = g.collapse(5, 10, Placement::at(t));
    ASSERT_TRUE(o);
    EXPECT_EQ(g.at(merged_vertex(g.t, NodeId::root, o)), a * (1 - t) + b * t);
  }
}

TEST(Placement, KeepsTheIndexOfTheEndThatKeepsItsPlace) {
  Grid g;
  EXPECT_EQ(merged_vertex(g.t, NodeId::root, g.collapse(5, 10, Placement::keep_a())), 5U);
  Grid h;
  EXPECT_EQ(merged_vertex(h.t, NodeId::root, h.collapse(5, 10, Placement::keep_b())), 10U);
}

TEST(Placement, GoesToTheBoundaryUnlessToldOtherwise) {
  for (const auto& [a, b] : {std::pair{4U, 5U}, {5U, 4U}}) {  // 4 is in the boundary
    Grid g;
    const Point3 rim = g.at(4), inside = g.at(5);
    const Outcome o = g.collapse(a, b, Placement::at(0.5));
    EXPECT_EQ(g.at(merged_vertex(g.t, NodeId::root, o)), rim);
    Grid h;
    const Outcome p = h.collapse(a, b, {.t = 0.5, .strict = false, .respect_strata = false});
    EXPECT_EQ(h.at(merged_vertex(h.t, NodeId::root, p)), (rim + inside) * 0.5);
  }
}

TEST(Placement, OfALockedVertexIsItsOwn) {
  Grid g;
  lock(g.t, NodeId::root, 10);
  const Point3 there = g.at(10);
  EXPECT_EQ(g.collapse(5, 10, Placement::keep_a()).refusal.check, Check::placement);
  const Outcome o = g.collapse(5, 10, Placement::at(0.25));
  ASSERT_TRUE(o);
  EXPECT_EQ(merged_vertex(g.t, NodeId::root, o), 10U);
  EXPECT_EQ(g.at(10), there);
}

TEST(Placement, TwoLockedEndsRefuse) {
  Grid g;
  lock(g.t, NodeId::root, 5);
  lock(g.t, NodeId::root, 10);
  EXPECT_EQ(g.collapse(5, 10, {}).refusal.check, Check::locked);
}

TEST(Placement, HonoursALockInAnyMesh) {
  Tree t = two_neighbors_plus_one();
  const NodeId whole =
      add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {3, 1, 0}, {0, 2, 4}, {3, 0, 4}}), {0, 1, 2, 3, 4});
  lock(t, whole, 2);
  const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, 2, 1), Placement::at(1));
  ASSERT_TRUE(o);
  EXPECT_EQ(merged_vertex(t, NodeId::root, o), 2U);
}

// The seam 0-1 of the cut child ends at the boundary: vertex 1 has two preimages, vertex 2 one.
TEST(Placement, HoldsTheEndOfASeam) {
  for (const bool a_is_seam : {true, false}) {
    Tree t = two_neighbors();
    const NodeId cut = add_cut_on_edge01(t, NodeId::root);
    const Point3 there = t.points(NodeId::root)[1];
    const Dart e = a_is_seam ? edge(t, cut, 1, 2) : edge(t, cut, 2, 1);
    EXPECT_EQ(
        t.operations->collapse(cut, e, a_is_seam ? Placement::keep_b() : Placement::keep_a()).refusal.check,
        Check::placement);
    const Outcome o = t.operations->collapse(cut, e, Placement::at(0.5));
    ASSERT_TRUE(o);
    EXPECT_EQ(t.points(cut)[merged_vertex(t, cut, o)], there);
    EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
  }
}

//  Three curves meet in the centre of a fan: it may not move.
TEST(Placement, HoldsAJunction) {
  for (const Placement p : {Placement::at(0), Placement::at(1), Placement::at(0.5)}) {
    Tree t = drawn({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}});
    (void)add_drawn(t, NodeId::root, segments({{0, 1}, {2, 3}, {4, 5}}), {0, 1, 0, 3, 0, 5});
    const Point3 centre = t.points(NodeId::root)[0];
    const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, 0, 1), p);
    ASSERT_EQ(o.refusal.check, Check::link_condition) << "the curve 0-1 has one edge only";
    ASSERT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 0, 1)));
    const Outcome second = t.operations->collapse(NodeId::root, edge(t, NodeId::root, 0, 7), p);
    ASSERT_TRUE(second);
    EXPECT_EQ(t.points(NodeId::root)[merged_vertex(t, NodeId::root, second)], centre);
  }
}

// Each end lies on another curve: neither may leave its curve.
//      1---2     curves 3-1 and 4-2 ... of two_neighbors: edge 1-2 joins them
TEST(Placement, IsImpossibleBetweenTwoCurves) {
  Tree t(grid(3, 3));
  const NodeId first = add_drawn(t, NodeId::root, segments({{0, 1}, {1, 2}}), {4, 5, 6});
  (void)add_drawn(t, NodeId::root, segments({{0, 1}, {1, 2}}), {8, 9, 10});
  EXPECT_EQ(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 5, 9)).refusal.check,
            Check::placement);
  EXPECT_TRUE(t.operations->collapse(first, edge(t, first, 0, 1)));
}

TEST(Placement, ChosenLateKnowsWhichEndIsHeld) {
  Grid g;
  lock(g.t, NodeId::root, 10);
  std::optional<double> held;
  const auto choose = [&](const Event& e, std::optional<double> h) {
    EXPECT_EQ(e.operation, Operation::collapse);
    held = h;
    return 0.25;
  };
  const Outcome o = g.t.operations->collapse(NodeId::root, edge(g.t, NodeId::root, 10, 5), choose);
  EXPECT_EQ(held, std::optional(0.0));
  EXPECT_EQ(merged_vertex(g.t, NodeId::root, o), 10U);
  Grid h;
  const Point3 a = h.at(5), b = h.at(10);
  const Outcome p = h.t.operations->collapse(NodeId::root, edge(h.t, NodeId::root, 5, 10), choose);
  EXPECT_EQ(held, std::nullopt);
  EXPECT_EQ(h.at(merged_vertex(h.t, NodeId::root, p)), a * 0.75 + b * 0.25);
}

// A curve 5-6 that ends inside the grid, and the boundary vertex 4: collapse of 4-5 would make it touch.
TEST(Contact, OfACurveWithTheBoundaryIsRefusedOnlyIfAsked) {
  for (const bool asked : {true, false}) {
    Tree t(grid(3, 3));
    (void)add_drawn(t, NodeId::root, segments({{0, 1}}), {5, 6});
    t.operations->set({.contact = asked});
    const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, 4, 5),
                                             {.t = 1, .strict = false, .respect_strata = false});
    EXPECT_EQ(o.refusal.check, asked ? Check::contact : Check::none);
  }
}

TEST(Contact, ThatIsThereAlreadyIsNotNew) {
  Tree t(grid(3, 3));
  const NodeId curve = add_drawn(t, NodeId::root, segments({{0, 1}, {1, 2}}), {4, 5, 6});
  t.operations->set({.contact = true});
  EXPECT_TRUE(t.operations->collapse(curve, edge(t, curve, 0, 1)));
  EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
}

// More children than a word has bits: each of them counts.
TEST(Contact, IsSeenForEveryOneOfManyChildren) {
  for (const int touching : {0, 62, 63, 64, 69}) {
    Tree t(grid(3, 3));
    for (int i = 0; i < 70; ++i)
      (void)add_drawn(t, NodeId::root, segments({{0, 1}}),
                      {i == touching ? 5U : 9U, i == touching ? 6U : 10U});
    t.operations->set({.contact = true});
    const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, 4, 5));
    EXPECT_EQ(o.refusal.check, Check::contact) << "child " << touching;
  }
}

// A value that a child takes from its parent, by a rule.
TEST(AttributeRule, SeesTheImageOfTheVertex) {
  Tree t = two_neighbors();
  const NodeId cut = add_cut_on_edge01(t, NodeId::root);
  Propagation ops(*t.tree);
  std::vector<VertexChange> seen;
  std::vector<int> none(64, 0);
  VertexAttribute<int> watch(cut, none, [&](Operation, const VertexChange& c) {
    seen.push_back(c);
    return static_cast<int>(c.above) + 100;
  });
  ops.add(watch);
  ASSERT_TRUE(ops.split(NodeId::root, edge(t, NodeId::root, 0, 1), 0.25));
  ASSERT_EQ(seen.size(), 2U) << "once per copy";
  for (const VertexChange& c : seen) {
    EXPECT_EQ(c.node, cut);
    EXPECT_EQ(c.t, 0.25);
    const Dart v = t.tree->mesh(cut).dart_of(0, c.vertex);
    EXPECT_EQ(t.tree->mesh(NodeId::root).vertex(t.tree->to_root(cut, v)), c.above);
    EXPECT_EQ(none[c.vertex], static_cast<int>(c.above) + 100);
  }
}

}  // namespace
}  // namespace multimesh::test
