// SPDX-License-Identifier: BSD-3-Clause
// The native swap against the split and collapse that defines it.
#include <gtest/gtest.h>

#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"

namespace multimesh::test {
namespace {

/// Whether every mesh of dimension 2 covers its parent, as UV meshes and tiles do.
bool surfaces_cover(const MultiMesh& tree) {
  for (const NodeId n : tree.nodes().subspan(1)) {
    const Mesh &below = tree.mesh(n), &above = tree.mesh(tree.parent(n));
    if (below.dimension() == 2 && simplices_of(below, 2).size() != simplices_of(above, 2).size())
      return false;
  }
  return true;
}

struct Result {
  Refusal refusal;
  PlainTree tree;
  oracle::Simplex diagonal;
};

Result try_swap(Tree& t, NodeId n, Dart e, Outcome (Propagation::*swap)(NodeId, Dart)) {
  const Transaction undone(*t.tree, {});
  const Outcome o = (t.operations.get()->*swap)(n, e);
  EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
  Result r{o.refusal, plain(oracle_tree(*t.tree)), {}};
  if (!o) return r;
  // Both name the new diagonal, one by an edge dart, the other by a dart at l.
  Index v[4];
  t.tree->mesh(n).vertices(o.dart, v);
  r.diagonal = oracle::simplex({static_cast<int>(v[0])});
  return r;
}

TEST(Swap, EqualsSplitAndCollapseWhereSurfacesCoverTheirParents) {
  std::size_t swapped = 0, refused = 0;
  for (unsigned seed = 0; seed < 150; ++seed) {
    const auto t = seed % 3 ? random_small_tree(seed)
                            : surface_tree_kinds()[seed / 3 % surface_tree_kinds().size()].make(16, seed);
    if (!surfaces_cover(*t->tree)) continue;
    for (const NodeId n : t->tree->nodes())
      for (const Dart e : simplices_of(t->tree->mesh(n), 1)) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", mesh " + std::to_string(index(n)) + ", dart " +
                     std::to_string(code(e)));
        const Result flip = try_swap(*t, n, e, &Propagation::swap);
        const Result reference = try_swap(*t, n, e, &Propagation::swap_by_split_and_collapse);
        ASSERT_EQ(flip.refusal.refused(), reference.refusal.refused()) << to_string(reference.refusal.check);
        ASSERT_EQ(flip.tree, reference.tree);
        ASSERT_EQ(flip.diagonal, reference.diagonal);
        ++(flip.refusal.refused() ? refused : swapped);
      }
  }
  EXPECT_GT(swapped, 100U);
  EXPECT_GT(refused, 100U);
}

// Where a surface covers only a part, split and collapse may also move the edge of that part; the native swap
// does not. What the native swap accepts is the same.
TEST(Swap, IsNeverMoreThanSplitAndCollapse) {
  for (unsigned seed = 200; seed < 350; ++seed) {
    const auto t = random_small_tree(seed);
    for (const NodeId n : t->tree->nodes())
      for (const Dart e : simplices_of(t->tree->mesh(n), 1)) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", mesh " + std::to_string(index(n)) + ", dart " +
                     std::to_string(code(e)));
        const Result flip = try_swap(*t, n, e, &Propagation::swap);
        if (flip.refusal.refused()) continue;
        const Result reference = try_swap(*t, n, e, &Propagation::swap_by_split_and_collapse);
        ASSERT_FALSE(reference.refusal.refused()) << to_string(reference.refusal.check);
        ASSERT_EQ(flip.tree, reference.tree);
      }
  }
}

TEST(Swap, OfABoundaryEdgeIsRefused) {
  Tree t = drawn({{0, 1, 2}});
  for (const Dart e : all_darts(t.tree->mesh(NodeId::root))) {
    EXPECT_EQ(t.operations->swap(NodeId::root, e).refusal.check, Check::flip);
    EXPECT_EQ(t.operations->swap_by_split_and_collapse(NodeId::root, e).refusal.check, Check::flip);
  }
}

TEST(Swap, InATetrahedronIsRefused) {
  Tree t = drawn({{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}});
  for (const Dart e : all_darts(t.tree->mesh(NodeId::root))) {
    EXPECT_FALSE(t.operations->swap(NodeId::root, e));
    EXPECT_FALSE(t.operations->swap_by_split_and_collapse(NodeId::root, e));
  }
}

TEST(Swap, OfASeamAndOfACurveIsRefused) {
  Tree t = two_neighbors();
  const NodeId cut = add_cut_on_edge01(t, NodeId::root);
  EXPECT_EQ(t.operations->swap(NodeId::root, edge(t, NodeId::root, 0, 1)).refusal.check, Check::flip);
  EXPECT_TRUE(t.operations->swap(cut, edge(t, cut, 0, 2)));
  Tree u = two_neighbors();
  const NodeId line = add_drawn(u, NodeId::root, segments({{0, 1}}), {0, 1});
  EXPECT_EQ(u.operations->swap(line, edge(u, line, 0, 1)).refusal.check, Check::flip);
  EXPECT_EQ(u.operations->swap_by_split_and_collapse(line, edge(u, line, 0, 1)).refusal.check, Check::flip);
}

// A curve on the outer edges of the two triangles is not touched, nor are the dead left behind.
//      0---3
//      | \ |     0-1-2-3-0 is a child
//      1---2
TEST(Swap, KeepsTheMapsOfTheOuterEdgesAndLeavesNothingDead) {
  Tree t = drawn({{0, 1, 2}, {0, 2, 3}});
  const NodeId rim = t.add_boundary(NodeId::root);
  ASSERT_TRUE(t.operations->swap(NodeId::root, edge(t, NodeId::root, 0, 2)));
  EXPECT_EQ(validate(*t.tree), std::vector<std::string>{});
  EXPECT_EQ(sorted_facets(t.tree->mesh(rim)).size(), 4U);
  for (int k = 0; k <= 2; ++k)
    EXPECT_EQ(simplices_of(t.tree->mesh(NodeId::root), k).size(), t.tree->mesh(NodeId::root).capacity(k));
}

}  // namespace
}  // namespace multimesh::test
