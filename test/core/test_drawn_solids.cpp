// SPDX-License-Identifier: BSD-3-Clause
// Operations on small tetrahedral trees drawn by hand: the effect on each child, in numbers of facets.
#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/support/solids.hpp"
#include "test/support/topology.hpp"

namespace multimesh::test {
namespace {

std::size_t facets(const Tree& t, NodeId n) {
  return simplices_of(t.tree->mesh(n), t.tree->mesh(n).dimension()).size();
}

void expect_valid(const Tree& t) {
  EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
}

/// Six tetrahedra around 2-3:     4---0---1      rim 0, 1, 6, 7, 5, 4; tetrahedra 0 to 5 are
///                                 \ 2|3 /       0123, 0234, 2345, 2357, 2367, 1236
///                                 5--7--6
struct SixCycle {
  Tree t{six_cycle()};
  /// All triangles of the boundary at vertex 2.
  NodeId one_side() {
    return add_drawn(t, NodeId::root,
                     triangles({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}}),
                     {2, 0, 1, 6, 7, 5, 4});
  }
  NodeId inside() { return add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {1, 3, 2}}), {0, 2, 3, 5}); }
  NodeId two_below() { return add_drawn(t, NodeId::root, triangles({{0, 1, 2}, {0, 2, 3}}), {2, 5, 7, 6}); }
  NodeId ring() {
    return add_drawn(t, NodeId::root, segments({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}),
                     {0, 1, 6, 7, 5, 4});
  }
  NodeId part(Index tets) {
    return t.add_tagged(NodeId::root, 3, [=](Index tet) { return tet < tets; });
  }
  Outcome split(Index a, Index b) {
    const Outcome o = t.operations->split(NodeId::root, edge(t, NodeId::root, a, b));
    expect_valid(t);
    return o;
  }
  Outcome collapse(Index a, Index b) {
    const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, a, b));
    expect_valid(t);
    return o;
  }
  std::size_t tets() const { return facets(t, NodeId::root); }
};

TEST(SplitSolid, TakesItsBoundaryAlong) {
  const auto counts = [](Index a, Index b) {
    SixCycle s;
    const NodeId rim = s.t.add_boundary(NodeId::root);
    EXPECT_EQ(facets(s.t, rim), 12U);
    EXPECT_TRUE(s.split(a, b));
    for (const Dart d : simplices_of(s.t.tree->mesh(rim), 2))
      EXPECT_TRUE(s.t.tree->mesh(NodeId::root).is_boundary(s.t.tree->to_parent(rim, d), 2));
    return std::pair{s.tets(), facets(s.t, rim)};
  };
  EXPECT_EQ(counts(2, 3), (std::pair<std::size_t, std::size_t>{12, 12})) << "inside";
  EXPECT_EQ(counts(0, 1), (std::pair<std::size_t, std::size_t>{7, 14})) << "on the rim";
  EXPECT_EQ(counts(0, 2), (std::pair<std::size_t, std::size_t>{8, 14})) << "a spoke";
}

TEST(SplitSolid, TakesACurveAlong) {
  const auto counts = [](Index a, Index b) {
    SixCycle s;
    const NodeId ring = s.ring();
    EXPECT_TRUE(s.split(a, b));
    return facets(s.t, ring);
  };
  EXPECT_EQ(counts(2, 3), 6U);
  EXPECT_EQ(counts(0, 1), 7U);
  EXPECT_EQ(counts(0, 2), 6U);
}

TEST(SplitSolid, TakesAPartAlong) {
  const auto counts = [](Index a, Index b) {
    SixCycle s;
    const NodeId part = s.part(3);
    EXPECT_TRUE(s.split(a, b));
    return facets(s.t, part);
  };
  EXPECT_EQ(counts(2, 3), 6U);
  EXPECT_EQ(counts(0, 1), 4U);
  EXPECT_EQ(counts(0, 2), 5U);
  EXPECT_EQ(counts(2, 6), 3U);
}

/// The four surfaces at once.
struct Surfaces : SixCycle {
  NodeId side = one_side(), whole = t.add_boundary(NodeId::root), within = inside(), below = two_below();
  std::vector<std::size_t> counts() const {
    return {tets(), facets(t, side), facets(t, whole), facets(t, within), facets(t, below)};
  }
};

TEST(CollapseSolid, TakesSurfacesAlong) {
  const auto after = [](Index a, Index b) {
    Surfaces s;
    EXPECT_TRUE(s.collapse(a, b)) << a << "-" << b;
    return s.counts();
  };
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(Surfaces().counts(), (Counts{6, 6, 12, 2, 2}));
  EXPECT_EQ(after(0, 1), (Counts{5, 5, 10, 2, 2}));
  EXPECT_EQ(after(0, 2), (Counts{4, 4, 10, 1, 2}));
}

// 0-3 runs from the rim of the one-sided surface to a vertex that is not on it, but on others.
TEST(CollapseSolid, TakesSurfacesAlongWhereEachIsOnOneSide) {
  SixCycle s;
  const NodeId whole = s.t.add_boundary(NodeId::root), within = s.inside(), below = s.two_below();
  ASSERT_TRUE(s.collapse(0, 3));
  EXPECT_EQ(s.tets(), 4U);
  EXPECT_EQ(facets(s.t, whole), 10U);
  EXPECT_EQ(facets(s.t, within), 1U);
  EXPECT_EQ(facets(s.t, below), 2U);
  SixCycle one;
  const NodeId side = one.one_side();
  ASSERT_TRUE(one.collapse(0, 3));
  EXPECT_EQ(facets(one.t, side), 6U);
}

TEST(CollapseSolid, IsRefusedWhereASurfaceWouldVanishOrTheSolidBePinched) {
  Surfaces s;
  EXPECT_EQ(s.collapse(2, 3).refusal.check, Check::link_condition)
      << "inside, with both ends in the boundary";
  EXPECT_EQ(s.collapse(2, 7).refusal.check, Check::link_condition);
  EXPECT_EQ(s.collapse(2, 7).refusal.node, s.below);
  EXPECT_EQ(s.counts(), (std::vector<std::size_t>{6, 6, 12, 2, 2}));
}

TEST(CollapseSolid, TakesACurveAlong) {
  SixCycle s;
  const NodeId ring = s.ring();
  ASSERT_TRUE(s.collapse(0, 1));
  EXPECT_EQ(facets(s.t, ring), 5U);
  SixCycle spoke;
  const NodeId untouched = spoke.ring();
  ASSERT_TRUE(spoke.collapse(0, 2)) << "its anchors move";
  EXPECT_EQ(facets(spoke.t, untouched), 6U);
  SixCycle single;
  const NodeId line = add_drawn(single.t, NodeId::root, segments({{0, 1}}), {2, 7});
  EXPECT_EQ(single.collapse(2, 7).refusal.check, Check::link_condition);
  EXPECT_EQ(single.collapse(2, 7).refusal.node, line);
}

// A ring holds vertex 0 in place, a line vertex 2: with both, neither end may move.
TEST(CollapseSolid, IsRefusedWhereTwoCurvesHoldBothEnds) {
  SixCycle s;
  (void)s.ring();
  (void)add_drawn(s.t, NodeId::root, segments({{0, 1}}), {2, 7});
  EXPECT_EQ(s.collapse(0, 2).refusal.check, Check::placement);
}

TEST(CollapseSolid, TakesPartsAlong) {
  const auto after = [](Index a, Index b) {
    SixCycle s;
    const NodeId three = s.part(3);
    const NodeId one = s.t.add_tagged(NodeId::root, 3, [](Index tet) { return tet == 1; });
    EXPECT_TRUE(s.collapse(a, b)) << a << "-" << b;
    return std::pair{facets(s.t, three), facets(s.t, one)};
  };
  EXPECT_EQ(after(0, 1), (std::pair<std::size_t, std::size_t>{2, 1}));
  EXPECT_EQ(after(1, 2), (std::pair<std::size_t, std::size_t>{2, 1}));
}

TEST(CollapseSolid, IsRefusedWhereAPartWouldLoseItsLastTetrahedron) {
  SixCycle s;
  (void)s.part(3);
  const NodeId one = s.t.add_tagged(NodeId::root, 3, [](Index tet) { return tet == 1; });
  EXPECT_FALSE(s.collapse(2, 3));
  const Outcome o = s.collapse(0, 4);
  EXPECT_EQ(o.refusal.check, Check::link_condition);
  EXPECT_EQ(o.refusal.node, one);
}

// --- swaps ------------------------------------------------------------------------------------------------

TEST(SwapSolid, ThreeToTwoAndBack) {
  Tree t(three_cycle());
  const NodeId copy = t.add_tagged(NodeId::root, 3, [](Index) { return true; });
  ASSERT_TRUE(t.operations->swap(NodeId::root, edge(t, NodeId::root, 0, 1)));
  expect_valid(t);
  using Facets = std::vector<std::vector<Index>>;
  EXPECT_EQ(sorted_facets(t.tree->mesh(NodeId::root)), (Facets{{0, 2, 3, 4}, {1, 2, 3, 4}}));
  EXPECT_EQ(facets(t, copy), 2U);
  const Dart face = find_dart(t.tree->mesh(NodeId::root), {2, 3, 4});
  ASSERT_TRUE(t.operations->swap_face(NodeId::root, face));
  expect_valid(t);
  EXPECT_EQ(sorted_facets(t.tree->mesh(NodeId::root)), (Facets{{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 3, 4}}));
  EXPECT_EQ(facets(t, copy), 3U);
}

TEST(SwapSolid, FourToFourGoesToTheApexOfTheDart) {
  for (const Index apex : {2U, 3U, 4U, 5U}) {
    Tree t(four_cycle());
    const Dart e = find_dart(t.tree->mesh(NodeId::root), {0, 1, apex});
    ASSERT_NE(e, no_dart);
    ASSERT_TRUE(t.operations->swap(NodeId::root, e));
    expect_valid(t);
    EXPECT_EQ(facets(t, NodeId::root), 4U);
    const Index across = 2 + (apex - 2 + 2) % 4;
    EXPECT_NE(find_dart(t.tree->mesh(NodeId::root), {apex, across}), no_dart);
  }
}

TEST(SwapSolid, SixToEight) {
  Tree t(six_cycle());
  ASSERT_TRUE(t.operations->swap(NodeId::root, edge(t, NodeId::root, 2, 3)));
  expect_valid(t);
  EXPECT_EQ(facets(t, NodeId::root), 8U) << "2 (n - 2)";
}

TEST(SwapSolid, OfAFaceWithoutAConvexEdgeAlreadyThereIsRefused) {
  Tree t(one_ear());
  const Mesh& root = t.tree->mesh(NodeId::root);
  ASSERT_TRUE(t.operations->swap_face(NodeId::root, find_dart(root, {0, 2, 3})));
  expect_valid(t);
  EXPECT_EQ(facets(t, NodeId::root), 3U);
  // Now 1-4 is an edge: no face between its two ends can be swapped onto it again.
  Tree closed(tetrahedra({{1, 2, 3, 4}, {0, 2, 3, 4}, {0, 1, 3, 4}, {0, 1, 2, 4}, {0, 1, 2, 3}}));
  for (const Dart f : simplices_of(closed.tree->mesh(NodeId::root), 2))
    EXPECT_FALSE(closed.operations->swap_face(NodeId::root, f));
  for (const Dart f : simplices_of(root, 2))
    if (root.is_boundary(f, 2)) {
      EXPECT_EQ(t.operations->swap_face(NodeId::root, f).refusal.check, Check::flip);
    }
}

TEST(SwapSolid, OfAnEdgeOrFaceThatAChildHasIsRefusedUnlessItSwapsIt) {
  SixCycle s;
  const NodeId within = s.inside();  // 0-2-3-5 across 2-3
  ASSERT_NE(find_dart(s.t.tree->mesh(NodeId::root), {2, 3, 1}), no_dart);
  EXPECT_FALSE(s.t.operations->swap(NodeId::root, find_dart(s.t.tree->mesh(NodeId::root), {2, 3, 1})))
      << "1 is no apex in the surface";
  EXPECT_FALSE(s.t.operations->swap_face(NodeId::root, find_dart(s.t.tree->mesh(NodeId::root), {0, 2, 3})));
  ASSERT_TRUE(s.t.operations->swap(NodeId::root, find_dart(s.t.tree->mesh(NodeId::root), {2, 3, 0})));
  expect_valid(s.t);
  EXPECT_EQ(facets(s.t, within), 2U);
  SixCycle curve;
  (void)add_drawn(curve.t, NodeId::root, segments({{0, 1}}), {2, 3});
  EXPECT_EQ(curve.t.operations->swap(NodeId::root, edge(curve.t, NodeId::root, 2, 3)).refusal.check,
            Check::flip);
}

// --- insertion --------------------------------------------------------------------------------------------

TEST(SplitSimplex, PutsAVertexIntoATetrahedronAFaceAndAnEdge) {
  const auto counts = [](int k) {
    SixCycle s;
    const NodeId whole = s.t.add_boundary(NodeId::root), part = s.part(3);
    const Dart d = find_dart(s.t.tree->mesh(NodeId::root), {0, 1, 2, 3});
    const Outcome o = s.t.operations->split_simplex(NodeId::root, d, k);
    EXPECT_TRUE(o);
    expect_valid(s.t);
    EXPECT_EQ(simplices_of(s.t.tree->mesh(NodeId::root), 0).size(), 9U);
    return std::vector<std::size_t>{s.tets(), facets(s.t, whole), facets(s.t, part)};
  };
  using Counts = std::vector<std::size_t>;
  EXPECT_EQ(counts(1), (Counts{7, 14, 4}));
  EXPECT_EQ(counts(2), (Counts{8, 14, 5})) << "a face of the boundary";
  EXPECT_EQ(counts(3), (Counts{9, 12, 6}));
}

// --- tags -------------------------------------------------------------------------------------------------

// Parts that meet in the edge 2-3 only come apart there.
TEST(TaggedTetrahedra, ComeApartWhereTheyDoNotShareFaces) {
  const auto counts = [](std::vector<Index> tets) {
    SixCycle s;
    const NodeId n = s.t.add_tagged(
        NodeId::root, 3, [&](Index t) { return std::find(tets.begin(), tets.end(), t) != tets.end(); });
    expect_valid(s.t);
    return std::pair{topology(s.t.tree->mesh(n)).components,
                     static_cast<long>(simplices_of(s.t.tree->mesh(n), 0).size())};
  };
  EXPECT_EQ(counts({0, 1}), (std::pair{1L, 5L}));
  EXPECT_EQ(counts({0, 1, 3, 4}), (std::pair{2L, 10L}));
  EXPECT_EQ(counts({0, 2, 4}), (std::pair{3L, 12L}));
  EXPECT_EQ(counts({0, 1, 2, 3, 4, 5}), (std::pair{1L, 8L}));
}

// Three faces at the edge 2-3: each for itself; two faces that share a vertex: apart.
TEST(TaggedTriangles3, ComeApartAtNonManifoldEdgesAndVertices) {
  const auto vertices_of = [](std::vector<std::array<Index, 3>> faces) {
    SixCycle s;
    std::vector<Index> tags;
    for (const auto& f : faces) {
      const Mesh& root = s.t.tree->mesh(NodeId::root);
      tags.push_back(root.simplex(find_dart(root, f), 2));
    }
    const NodeId n = s.t.add_tagged(
        NodeId::root, 2, [&](Index f) { return std::find(tags.begin(), tags.end(), f) != tags.end(); });
    expect_valid(s.t);
    return simplices_of(s.t.tree->mesh(n), 0).size();
  };
  EXPECT_EQ(vertices_of({{0, 2, 3}, {2, 3, 7}}), 4U);
  EXPECT_EQ(vertices_of({{0, 2, 3}, {2, 3, 7}, {2, 3, 1}}), 9U);
  EXPECT_EQ(vertices_of({{0, 1, 2}, {2, 5, 7}}), 6U);
}

TEST(Boundary3, OfATorusIsNoneAndOfAShellIsTwo) {
  Tree closed(torus3(3));
  EXPECT_THROW((void)closed.add_boundary(NodeId::root), InputError);
  Tree shell(layers(sphere(0), 1));
  EXPECT_EQ(topology(shell.tree->mesh(shell.add_boundary(NodeId::root))).components, 2);
}

}  // namespace
}  // namespace multimesh::test
