// SPDX-License-Identifier: BSD-3-Clause
// As test_reference_faults.cpp: faults that the reference implementation has in three dimensions.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "multimesh/validate.hpp"
#include "oracle/image.hpp"
#include "oracle/random_solid_trees.hpp"
#include "oracle/submesh.hpp"
#include "property/collapse_trials.hpp"
#include "property/shadow.hpp"
#include "test/support/solids.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

oracle::Solid any_solid(std::uint64_t seed) {
  return static_cast<oracle::Solid>(seed % 4);
}

// --- the anchor of a curve on a boundary edge is repaired from anchors that were just rewritten
// -------------

// A curve of boundary edges of a tetrahedral mesh, and collapses on the boundary until nothing goes any more.
TEST(ReferenceFaults3, CurvesOnTheBoundaryFollowCollapsesThere) {
  std::size_t collapses = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 rng(seed);
    const oracle::Solid kinds[] = {oracle::Solid::kBall, oracle::Solid::kSolidTorus, oracle::Solid::kShell};
    const oracle::Complex root = oracle::random_solid(kinds[seed % 3], 30, rng);
    oracle::Complex rim{2, {}};
    for (const oracle::Simplex& f : of_dimension(boundary(root), 2)) rim.facets.push_back(f.v);
    const oracle::Tree plain{{{root, -1, {}}, curve_child(root, 0, random_edges(rim, rng))}};
    auto tree = to_multimesh(plain, rng);
    ASSERT_TRUE(tree);
    Shadow shadow(*tree, seed);
    const Mesh& mesh = tree->mesh(NodeId::root);
    for (int i = 0; i < 150; ++i) {
      const auto e = static_cast<Index>(oracle::pick(rng, mesh.capacity(1)));
      if (!mesh.is_live(1, e) || !mesh.is_boundary(mesh.dart_of(1, e), 1)) continue;
      ASSERT_EQ(shadow.collapse(NodeId::root, mesh.dart_of(1, e)), "") << i;
      ASSERT_EQ(query_difference(*tree, shadow.plain()), "") << i;
    }
    collapses += shadow.collapses;
  }
  EXPECT_GT(collapses, 50U);
}

// --- map validity is looked at in one facet of the edge only
// ------------------------------------------------

// The verdict is the same whichever tetrahedron around the edge, and whichever direction, the dart has.
TEST(ReferenceFaults3, MapsAreJudgedInAllTetrahedraAroundTheEdge) {
  std::size_t asked = 0, refused = 0;
  for (std::uint64_t seed = 0; seed < 36; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 rng(seed);
    const auto kind = static_cast<oracle::SolidTreeKind>(seed % oracle::kNumberOfSolidTreeKinds);
    auto tree = to_multimesh(oracle::random_solid_tree(seed, kind, any_solid(seed)), rng);
    ASSERT_TRUE(tree);
    const Mesh& root = tree->mesh(NodeId::root);
    Propagation ops(*tree);
    ops.set({.contact = seed % 2 == 1});
    DartBuffer around;
    for (Index e = 0; e < root.capacity(1); ++e) {
      if (!root.is_live(1, e)) continue;
      const Check verdict = ops.judge(NodeId::root, root.dart_of(1, e)).refusal.check;
      root.star(root.dart_of(1, e), 1, around);
      const DartBuffer darts = around;
      for (const Dart d : darts)
        for (const Permutation p : {Permutation{}, exchange_ends, permutation(0, 1, 3, 2)}) {
          const Check here = ops.judge(NodeId::root, root.reorder(d, p)).refusal.check;
          EXPECT_EQ(here == Check::none, verdict == Check::none)
              << to_string(here) << " or " << to_string(verdict);
          ++asked;
          refused += here != Check::none;
        }
    }
  }
  EXPECT_GT(refused, asked / 10);
  EXPECT_LT(refused, asked);
}

// --- grandchildren are looked up in the wrong list
// ----------------------------------------------------------

// The same edge, requested on each mesh that has a copy of it: the effect is the same everywhere.
TEST(ReferenceFaults3, ItDoesNotMatterOnWhichMeshAnOperationIsAskedFor) {
  std::size_t from_grandchild = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    std::mt19937_64 rng(seed);
    auto tree =
        to_multimesh(oracle::random_solid_tree(seed, oracle::SolidTreeKind::kMixed, any_solid(seed)), rng);
    ASSERT_TRUE(tree);
    const oracle::Tree plain = to_oracle(*tree);
    const Mesh& root = tree->mesh(NodeId::root);
    Propagation ops(*tree);
    Records records(ops, *tree);
    for (Index e = 0; e < root.capacity(1); ++e) {
      if (!root.is_live(1, e)) continue;
      const Dart d = root.dart_of(1, e);
      const auto a = static_cast<int>(root.vertex(d)),
                 b = static_cast<int>(root.vertex(root.switch_dart(d, 0)));
      const oracle::SplitResult cut = oracle::split(plain, a, b);
      const oracle::CollapseResult merged = oracle::collapse(plain, a, b);
      const Check verdict = ops.judge(NodeId::root, d).refusal.check;
      Copies copies;
      copies.collect(*tree, d, 1);
      for (const Copy& c : copies.all()) {
        SCOPED_TRACE("seed " + std::to_string(seed) + " mesh " + std::to_string(index(c.node)));
        from_grandchild += tree->depth(c.node) >= 2;
        EXPECT_EQ(ops.judge(c.node, c.dart).refusal.check, verdict);
        for (const bool split : {true, false}) {
          records.clear();
          const Transaction undone(*tree, {});
          const Outcome outcome = split ? ops.split(c.node, c.dart) : ops.collapse(c.node, c.dart);
          const oracle::Tree expected = !outcome ? plain
                                        : split  ? renamed(cut.tree, records.names_after(cut))
                                                 : renamed(merged.tree, records.names_after(merged));
          ASSERT_EQ(tree_difference(expected, to_oracle(*tree)), "");
        }
      }
    }
  }
  EXPECT_GT(from_grandchild, 50U);
}

// --- periodic: vertices with 4 or 8 copies never move
// -------------------------------------------------------

class PeriodicCorners : public testing::Test {
 protected:
  PeriodicCorners() {
    for (const TreeKind& kind : solid_tree_kinds())
      if (kind.name == "Torus3Tile") t_ = kind.make(0, 0);
  }
  MultiMesh& tree() const { return *t_->tree; }
  const Mesh& root() const { return tree().mesh(NodeId::root); }
  std::size_t copies_in_tile(Dart d, int k) const {
    DartBuffer found;
    tree().to_child(tile, d, k, found);
    return found.size();
  }
  static constexpr NodeId tile{1};
  std::unique_ptr<Tree> t_;
};

TEST_F(PeriodicCorners, HaveEightCopiesAndAllMoveTogether) {
  std::map<std::size_t, std::size_t> vertices;
  for (Index v = 0; v < root().capacity(0); ++v) {
    const Dart d = root().dart_of(0, v);
    const std::size_t n = copies_in_tile(d, 0);
    ++vertices[n];
    const Point3 to(static_cast<double>(v), 2, 3);
    ASSERT_TRUE(t_->operations->relocate(NodeId::root, d, [&](const Event& event) {
      EXPECT_EQ(event.copies.of(tile).size(), n);
      for (const Copy& c : event.copies.all())
        t_->attribute(c.node).set(event.tree.mesh(c.node).vertex(c.dart), to);
    }));
    DartBuffer found;
    tree().to_child(tile, d, 0, found);
    for (const Dart copy : found) EXPECT_EQ(t_->points(tile)[tree().mesh(tile).vertex(copy)], to);
  }
  EXPECT_EQ(vertices, (std::map<std::size_t, std::size_t>{{1, 27}, {2, 27}, {4, 9}, {8, 1}}));
}

// Split, collapse and swap around a vertex with so many copies: all are possible, and the copies keep their
// place.
TEST_F(PeriodicCorners, TakePartInEveryOperation) {
  std::map<std::size_t, std::size_t> splits, collapses;
  std::vector<Index> edges;
  for (Index e = 0; e < root().capacity(1); ++e)
    if (root().is_live(1, e)) edges.push_back(e);
  for (const Index e : edges) {
    const Dart d = root().dart_of(1, e), back = root().reorder(d, exchange_ends);
    const std::size_t at_a = copies_in_tile(d, 0), at_b = copies_in_tile(back, 0);
    const std::size_t most = std::max(at_a, at_b), on_edge = copies_in_tile(d, 1);
    if (most < 4) continue;
    SCOPED_TRACE("edge " + std::to_string(e));
    const Index held = root().vertex(at_a > at_b ? d : back);
    const auto a = static_cast<int>(root().vertex(d)), b = static_cast<int>(root().vertex(back));
    const Point3 place = t_->points(NodeId::root)[held];
    auto transaction = t_->operations->transaction();
    ASSERT_TRUE(t_->operations->split(NodeId::root, d));
    EXPECT_EQ(t_->operations->copies().of(tile).size(), on_edge);
    ++splits[on_edge];
    const Dart half = t_->operations->copies()[0].dart;
    ASSERT_TRUE(t_->operations->collapse(NodeId::root, half, Placement::keep_a()))
        << "the new vertex goes back";
    ASSERT_EQ(validate(tree()), std::vector<std::string>{});
    const Outcome merged =
        t_->operations->collapse(NodeId::root, edge_dart(root(), a, b), Placement::at(0.5));
    if (!merged) continue;  // gluing in the cube: an edge from side to side
    ASSERT_EQ(validate(tree()), std::vector<std::string>{});
    EXPECT_EQ(copies_in_tile(merged.root, 0), most);
    if (at_a != at_b) {
      EXPECT_EQ(t_->points(NodeId::root)[root().vertex(merged.root)], place) << "held";
      ++collapses[most];
    }
  }
  EXPECT_GT(splits[4], 0U) << "edges of the cube";
  EXPECT_GT(splits[2], 0U);
  EXPECT_GT(collapses[4], 0U);
  EXPECT_GT(collapses[8], 0U);
}

// --- non-manifold tags crash later
// --------------------------------------------------------------------------

TEST(ReferenceFaults3, AnyTagsMakeAChildThatFollowsOperations) {
  std::size_t cut_vertices = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 rng(seed);
    Tree t(seed % 2 ? six_cycle() : box(1, 2, 1));
    const int k = 1 + static_cast<int>(seed % 3);
    const Mesh& root = t.tree->mesh(NodeId::root);
    const NodeId child =
        t.add_tagged(NodeId::root, k, [&](Index s) { return s == 0 || oracle::chance(rng, 40); });
    std::set<Index> images;
    std::size_t vertices = 0;
    const Mesh& mesh = t.tree->mesh(child);
    for (Index v = 0; v < mesh.capacity(0); ++v) {
      if (mesh.dart_of(0, v) == no_dart) continue;
      ++vertices;
      images.insert(root.vertex(t.tree->to_root(child, mesh.dart_of(0, v))));
    }
    cut_vertices += vertices - images.size();
    ASSERT_EQ(oracle::tree_error(to_oracle(*t.tree)), "");
    Shadow shadow(*t.tree, seed);
    for (int i = 0; i < 60; ++i) ASSERT_EQ(shadow.step(), "") << i;
  }
  EXPECT_GT(cut_vertices, 40U);
}

}  // namespace
}  // namespace multimesh::test
