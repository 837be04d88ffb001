// SPDX-License-Identifier: BSD-3-Clause
// Meshes of dimension 0: points that the operations on the meshes above leave where they are.
#include <gtest/gtest.h>

#include <random>

#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/openmesh/add_values.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/support/fingerprint.hpp"

namespace multimesh::test {
namespace {

//   8---9---10--11
//   |  /|  /|  /|     grid(3, 2) is 4 x 3 vertices: vertex (i,j) is 3 i + j
const auto at = [](std::set<Index> list) {
  return [list = std::move(list)](Index v) { return list.contains(v); };
};

/// The vertex of the root under each point.
std::vector<Index> root_vertices(const Tree& t, NodeId points) {
  std::vector<Index> below;
  for (const Dart p : simplices_of(t.tree->mesh(points), 0))
    below.push_back(t.tree->mesh(NodeId::root).vertex(t.tree->to_root(points, p)));
  return below;
}

TEST(Points, LieOverTheTaggedVertices) {
  Tree t(grid(3, 2));
  const NodeId points = t.add_tagged(NodeId::root, 0, at({2, 5, 7}));
  EXPECT_EQ(t.tree->mesh(points).dimension(), 0);
  EXPECT_EQ(root_vertices(t, points), (std::vector<Index>{2, 5, 7}));
  EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
  DartBuffer found;
  const Mesh& root = t.tree->mesh(NodeId::root);
  t.tree->to_child(points, root.dart_of(0, 5), 0, found);
  EXPECT_EQ(found.size(), 1U);
  EXPECT_FALSE(t.tree->has_preimage(NodeId::root, root.dart_of(0, 6), 0, points));
  EXPECT_FALSE(t.tree->has_preimage(NodeId::root, root.dart_of(0, 5), 1, points)) << "no edge has one";
}

TEST(Points, OfAVertexWithoutFacetsAreRefused) {
  MultiMesh tree(make_mesh({2, 4, {0, 1, 2}}));
  EXPECT_THROW((void)add_child_from_tags(
                   tree, NodeId::root, 0, [](Index v) { return v == 3; }, make_mesh),
               InputError);
  EXPECT_EQ(tree.nodes().size(), 1U);
  const NodeId all = add_child_from_tags(
      tree, NodeId::root, 0, [](Index v) { return v < 3; }, make_mesh);
  EXPECT_EQ(validate(tree), std::vector<std::string>{});
  EXPECT_EQ(tree.mesh(all).capacity(0), 3U);
}

TEST(Points, AreMadeFromListsThatNumberThemInOrderOnly) {
  EXPECT_THROW((void)make_mesh({0, 3, {0, 2, 1}}), InputError);
  EXPECT_THROW((void)make_mesh({0, 3, {0, 1}}), InputError);
  EXPECT_NO_THROW((void)make_mesh({0, 2, {0, 1}}));
}

TEST(Points, CutTakesPointsInOneVertexApart) {
  const Cut pieces = cut({0, 5, {4, 1, 4}});
  EXPECT_EQ(pieces.facets.corners, (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(pieces.facets.vertices, 3U);
  EXPECT_EQ(pieces.source, (std::vector<Index>{4, 1, 4}));
}

// A child has at most one facet over a simplex of its parent.
TEST(Points, TwoOverOneVertexAreRefused) {
  Tree t(grid(3, 2));
  const Mesh& root = t.tree->mesh(NodeId::root);
  const std::vector<Anchor> anchors{{Dart{0}, root.dart_of(0, 4)}, {Dart{1}, root.dart_of(0, 4)}};
  EXPECT_THROW((void)t.tree->add_child(NodeId::root, make_mesh({0, 2, {0, 1}}), anchors), InputError);
}

TEST(Points, HoldTheirEndOfACollapse) {
  for (const bool swapped : {false, true}) {
    Tree t(grid(3, 2));
    (void)t.add_tagged(NodeId::root, 0, at({4}));
    const Point3 place = t.points(NodeId::root)[4];
    const Dart e = swapped ? edge(t, NodeId::root, 7, 4) : edge(t, NodeId::root, 4, 7);
    const CollapseVerdict verdict = t.operations->judge(NodeId::root, e);
    EXPECT_EQ(verdict.hold_a, !swapped);
    EXPECT_EQ(verdict.hold_b, swapped);
    ASSERT_TRUE(t.operations->collapse(NodeId::root, e, Placement::at(0.5)));
    EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
    EXPECT_TRUE(t.tree->mesh(NodeId::root).is_live(0, 4));
    EXPECT_EQ(t.points(NodeId::root)[4], place);
  }
}

TEST(Points, TwoAreNotMergedIntoOne) {
  Tree t(grid(3, 2));
  const NodeId points = t.add_tagged(NodeId::root, 0, at({4, 7}));
  const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, 4, 7));
  EXPECT_EQ(o.refusal.check, Check::gluing);
  EXPECT_EQ(o.refusal.node, points);
}

// Of two meshes, each with one end: both hold their end.
TEST(Points, OfTwoMeshesHoldBothEnds) {
  Tree t(grid(3, 2));
  (void)t.add_tagged(NodeId::root, 0, at({4}));
  (void)t.add_tagged(NodeId::root, 0, at({7}));
  const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, 4, 7));
  EXPECT_EQ(o.refusal.check, Check::placement);
}

// The anchor of the point lies on the edge that is swapped, in each of its triangles and directions.
TEST(Points, AtTheEndsOfASwappedEdgeStayThere) {
  for (const Index a : {0U, 2U})
    for (const bool other_side : {false, true}) {
      Tree t = drawn({{0, 1, 2}, {0, 2, 3}});
      const Mesh& root = t.tree->mesh(NodeId::root);
      const Dart e = edge(t, NodeId::root, a, 2 - a);
      const Dart anchor = other_side ? root.switch_dart(e, 2) : e;
      const std::vector<Anchor> anchors{{Dart{0}, anchor}};
      const NodeId points = t.add(t.tree->add_child(NodeId::root, make_mesh({0, 1, {0}}), anchors));
      ASSERT_TRUE(t.operations->swap(NodeId::root, edge(t, NodeId::root, 0, 2)));
      EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
      EXPECT_EQ(root_vertices(t, points), (std::vector<Index>{a}));
    }
}

TEST(Points, HaveNoEdgesToOperateOn) {
  Tree t(grid(3, 2));
  const NodeId points = t.add_tagged(NodeId::root, 0, at({4, 7}));
  Propagation& ops = *t.operations;
  const Dart p = t.tree->mesh(points).dart_of(0, 0);
  const auto before = fingerprint(t);
  EXPECT_THROW((void)ops.split(points, p), UsageError);
  EXPECT_THROW((void)ops.collapse(points, p), UsageError);
  EXPECT_THROW((void)ops.collapse(points, p, [](const Event&, auto) { return 0.5; }), UsageError);
  EXPECT_THROW((void)ops.swap(points, p), UsageError);
  EXPECT_THROW((void)ops.swap_by_split_and_collapse(points, p), UsageError);
  EXPECT_THROW((void)ops.split_simplex(points, p, 1), UsageError);
  EXPECT_THROW((void)ops.judge(points, p), UsageError);
  EXPECT_THROW((void)ops.why_not_collapse(points, p), UsageError);
  EXPECT_THROW((void)ops.why_not_swap(points, p), UsageError);
  EXPECT_EQ(ops.swap_face(points, p).refusal.check, Check::flip);
  EXPECT_EQ(fingerprint(t), before);
}

TEST(Points, AreMovedWithAllThatLiesOverTheSameVertex) {
  Tree t(grid(3, 2));
  const NodeId rim = t.add_boundary(NodeId::root);
  const NodeId ends = t.add_tagged(rim, 0, [](Index) { return true; });
  const Dart p = t.tree->mesh(ends).dart_of(0, 2);
  const Point3 old = t.points(ends)[2];
  ASSERT_TRUE(t.move(ends, p, Point3(1, 2, 3)));
  EXPECT_EQ(t.points(ends)[2], old + Point3(1, 2, 3));
  EXPECT_EQ(t.points(NodeId::root)[t.tree->mesh(NodeId::root).vertex(t.tree->to_root(ends, p))],
            old + Point3(1, 2, 3));
}

/// Trees of all kinds that have points.
const std::vector<TreeKind>& kinds_with_points() {
  static const std::vector<TreeKind> kinds = [] {
    std::vector<TreeKind> some;
    for (const TreeKind& k : tree_kinds())
      if (k.name.find("Points") != std::string::npos) some.push_back(k);
    return some;
  }();
  return kinds;
}

class StormOnPoints : public testing::TestWithParam<TreeKind> {};

// Unless a vertex is moved, every point stays at its place, with its own values.
TEST_P(StormOnPoints, LeavesEachPointWhereItIsWithItsValues) {
  std::size_t done = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const auto t = GetParam().make(30, seed);
    MultiMesh& tree = *t->tree;
    struct Known {
      NodeId node;
      std::vector<int>* names;
      std::vector<Point3> places;  // by name
    };
    std::vector<Known> all;
    for (const NodeId n : tree.nodes()) {
      Mesh& mesh = tree.mesh(n);
      if (mesh.dimension() > 0) continue;
      auto& om = dynamic_cast<openmesh::Connectivity&>(mesh).openmesh();
      auto& names = openmesh::add_values(om, OpenMesh::VPropHandleT<int>(), "name");
      for (std::size_t i = 0; i < names.size(); ++i) names[i] = static_cast<int>(i);
      all.push_back({n, &names, t->points(n)});
    }
    ASSERT_FALSE(all.empty());
    std::mt19937 random(seed);
    for (int i = 0; i < 150; ++i) {
      NodeId n = tree.nodes()[random() % tree.nodes().size()];
      while (tree.mesh(n).dimension() == 0) n = tree.parent(n);
      const DartBuffer edges = simplices_of(tree.mesh(n), 1);
      const Dart e = edges[random() % edges.size()];
      const auto choice = random() % 8;
      done += choice < 2   ? bool(t->operations->split(n, e))
              : choice < 6 ? bool(t->operations->collapse(n, e, Placement::at(0.5)))
                           : bool(t->operations->swap(n, e));
      if (i % 40 == 39) tree.compact();
    }
    ASSERT_EQ(validate(tree), std::vector<std::string>{});
    const Mesh& root = tree.mesh(NodeId::root);
    for (const Known& k : all) {
      const Mesh& mesh = tree.mesh(k.node);
      ASSERT_EQ(simplices_of(mesh, 0).size(), k.places.size()) << "no point goes, and none comes";
      for (const Dart p : simplices_of(mesh, 0)) {
        const auto name = static_cast<std::size_t>((*k.names)[mesh.vertex(p)]);
        EXPECT_EQ(t->points(k.node)[mesh.vertex(p)], k.places[name]);
        EXPECT_EQ(t->points(NodeId::root)[root.vertex(tree.to_root(k.node, p))], k.places[name]);
      }
    }
  }
  EXPECT_GT(done, 300U);
}

INSTANTIATE_TEST_SUITE_P(Trees, StormOnPoints, testing::ValuesIn(kinds_with_points()),
                         [](const auto& kind) { return kind.param.name; });

TEST(Locks, HoldAVertexOfAnyMesh) {
  Tree t(grid(3, 2));
  const NodeId rim = t.add_boundary(NodeId::root);
  Mesh& curve = t.tree->mesh(rim);
  const Index v = curve.vertex(curve.dart_of(0, 3));
  curve.set_locked(v, true);
  EXPECT_TRUE(curve.is_locked(v));
  EXPECT_TRUE(t.operations->judge(rim, curve.dart_of(0, v)).hold_a);
  curve.set_locked(v, false);
  EXPECT_FALSE(curve.is_locked(v));
  EXPECT_FALSE(t.operations->judge(rim, curve.dart_of(0, v)).hold_a);
}

TEST(Locks, OfASolidSurviveItsCompaction) {
  const auto t = solid_tree_kinds().front().make(24, 0);
  Mesh& root = t->tree->mesh(NodeId::root);
  root.set_locked(2, true);
  const Point3 place = t->points(NodeId::root)[2];
  for (Index i = 0; i < 6; ++i) {
    const DartBuffer edges = simplices_of(root, 1);
    (void)t->operations->collapse(NodeId::root, edges[(7 * i) % edges.size()]);
  }
  const auto moved = t->tree->compact();
  const Index now = moved[0].simplices[0][2];
  ASSERT_NE(now, no_index);
  EXPECT_TRUE(root.is_locked(now));
  EXPECT_EQ(t->points(NodeId::root)[now], place);
}

}  // namespace
}  // namespace multimesh::test
