// SPDX-License-Identifier: BSD-3-Clause
// Children made of tagged simplices: separated at non-manifold places.
#include <gtest/gtest.h>

#include <set>

#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/support/topology.hpp"

namespace multimesh::test {
namespace {

using Edges = std::set<Segment>;

/// A closed fan of six triangles, (0,1,2), (0,2,3) ... (0,6,1).
struct Fan {
  Fan() : t(drawn({{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}})) {}

  NodeId add(int k, const std::function<bool(Index)>& tagged) {
    const NodeId n = t.add_tagged(NodeId::root, k, tagged);
    EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
    return n;
  }
  NodeId add_facets(const std::set<Index>& list) {
    return add(2, [&](Index f) { return list.contains(f); });
  }
  NodeId add_edges(const Edges& list) {
    return add(1, [&](Index e) {
      Index v[4];
      t.tree->mesh(NodeId::root).vertices(t.tree->mesh(NodeId::root).dart_of(1, e), v);
      return list.contains({v[0], v[1]}) || list.contains({v[1], v[0]});
    });
  }
  /// Live vertices and facets of a child.
  std::array<Index, 2> counts(NodeId n) const {
    const Mesh& m = t.tree->mesh(n);
    return {static_cast<Index>(simplices_of(m, 0).size()),
            static_cast<Index>(simplices_of(m, m.dimension()).size())};
  }
  Tree t;
};

using Counts = std::array<Index, 2>;

TEST(TaggedTriangles, InOnePieceKeepTheCentre) {
  Fan f;
  EXPECT_EQ(f.counts(f.add_facets({0, 1, 2, 3})), (Counts{6, 4}));
}

TEST(TaggedTriangles, InTwoPiecesDoubleTheCentre) {
  Fan f;
  EXPECT_EQ(f.counts(f.add_facets({0, 1, 3, 4})), (Counts{8, 4}));
}

TEST(TaggedTriangles, InThreePiecesTripleTheCentre) {
  Fan f;
  const NodeId n = f.add_facets({0, 2, 4});
  EXPECT_EQ(f.counts(n), (Counts{9, 3}));
  DartBuffer found;
  f.t.tree->to_child(n, edge(f.t, NodeId::root, 0, 1), 0, found);
  EXPECT_EQ(found.size(), 3U) << "preimages of the centre";
}

TEST(TaggedTriangles, MayBeAll) {
  Fan f;
  EXPECT_EQ(f.counts(f.add_facets({0, 1, 2, 3, 4, 5})), (Counts{7, 6}));
}

TEST(TaggedEdges, OnAPathAreAChain) {
  Fan f;
  EXPECT_EQ(f.counts(f.add_edges({{1, 0}, {0, 4}, {4, 5}})), (Counts{4, 3}));
}

TEST(TaggedEdges, ThatBranchComeApartThere) {
  Fan f;
  EXPECT_EQ(f.counts(f.add_edges({{0, 1}, {0, 3}, {0, 5}})), (Counts{6, 3}));
}

//   Two loops 0-1-2 and 0-4-5 that meet in the centre: four edges there.
TEST(TaggedEdges, OfTwoLoopsThatTouchBecomeTwoChains) {
  Fan f;
  EXPECT_EQ(f.counts(f.add_edges({{0, 1}, {1, 2}, {2, 0}, {0, 4}, {4, 5}, {5, 0}})), (Counts{8, 6}));
}

TEST(TaggedEdges, OfALoopStayClosed) {
  Fan f;
  EXPECT_EQ(f.counts(f.add_edges({{1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 6}, {6, 1}})), (Counts{6, 6}));
}

TEST(TaggedSimplices, OfNegativeOrTooHighDimensionAreRefused) {
  Fan f;
  const auto all = [](Index) { return true; };
  EXPECT_THROW((void)f.t.add_tagged(NodeId::root, -1, all), InputError);
  EXPECT_THROW((void)f.t.add_tagged(NodeId::root, 3, all), InputError);
  EXPECT_THROW((void)f.t.add_tagged(NodeId::root, 2, [](Index) { return false; }), InputError);
  EXPECT_EQ(f.t.tree->nodes().size(), 1U);
}

TEST(TaggedSimplices, AreAskedOncePerLiveIndex) {
  Fan f;
  ASSERT_TRUE(f.t.operations->collapse(NodeId::root, edge(f.t, NodeId::root, 1, 2)));
  std::multiset<Index> asked;
  (void)f.add(1, [&](Index e) { return asked.insert(e), true; });
  EXPECT_EQ(asked, [&] {
    std::multiset<Index> live;
    for (const Dart d : simplices_of(f.t.tree->mesh(NodeId::root), 1))
      live.insert(f.t.tree->mesh(NodeId::root).simplex(d, 1));
    return live;
  }());
}

TEST(Boundary, IsAChildPerLoopAndNoneIfClosed) {
  Tree ring(annulus(5, 2));
  const NodeId rim = ring.add_boundary(NodeId::root);
  EXPECT_EQ(topology(ring.tree->mesh(rim)).components, 2);
  Tree ball(sphere(0));
  EXPECT_THROW((void)ball.add_boundary(NodeId::root), InputError);
  Tree tri = drawn({{0, 1, 2}});
  const NodeId sides = tri.add_boundary(NodeId::root);
  EXPECT_EQ(sorted_facets(tri.tree->mesh(sides)).size(), 3U);
  EXPECT_THROW((void)tri.add_boundary(sides), InputError) << "a loop has no ends";
}

TEST(Boundary, OfCurvesIsTheirEnds) {
  Fan f;
  const NodeId curve = f.add_edges({{1, 0}, {0, 4}, {4, 5}});
  const NodeId ends = f.t.add_boundary(curve);
  EXPECT_EQ(validate(*f.t.tree), std::vector<std::string>{});
  EXPECT_EQ(f.t.tree->mesh(ends).dimension(), 0);
  std::set<Index> below;
  for (const Dart p : simplices_of(f.t.tree->mesh(ends), 0))
    below.insert(f.t.tree->mesh(NodeId::root).vertex(f.t.tree->to_root(ends, p)));
  EXPECT_EQ(below, (std::set<Index>{1, 5}));
  EXPECT_THROW((void)f.t.add_boundary(ends), InputError) << "points have no boundary";
}

}  // namespace
}  // namespace multimesh::test
