// SPDX-License-Identifier: BSD-3-Clause
// Verdicts on collapses against brute force: identify the ends, and check what has changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>

#include "oracle/collapse.hpp"
#include "oracle/random_trees.hpp"
#include "test/core/drawn.hpp"

namespace multimesh::test {
namespace {

/// test/property/test_legality_oracle.cpp tests whether images keep their type.
class CollapseVerdicts : public testing::TestWithParam<oracle::TreeKind> {
 protected:
  /// test(tree, plain tree, its signature) on random trees of this kind.
  template <class Test>
  void on_trees(unsigned trees, const Test& test) {
    for (unsigned seed = 0; seed < trees; ++seed) {
      const auto surface = static_cast<oracle::Surface>(seed % (oracle::kNumberOfSurfaces - 1));
      const auto tree =
          tree_from(oracle::random_tree(seed, GetParam(), surface, {.min_facets = 6, .max_facets = 16}));
      if (!tree) continue;
      SCOPED_TRACE("seed " + std::to_string(seed));
      test(*tree, oracle_tree(*tree->tree));
    }
  }
};

TEST_P(CollapseVerdicts, AcceptsNoCollapseThatMakesATreeInvalid) {
  std::size_t accepted = 0;
  on_trees(60, [&](Tree& t, const oracle::Tree& plain_tree) {
    for (const Dart e : simplices_of(t.tree->mesh(NodeId::root), 1)) {
      const Transaction undone(*t.tree, {});
      const auto ends = edge_copies(*t.tree, e)[0];
      if (!t.operations->collapse(NodeId::root, e)) continue;
      ++accepted;
      const auto judged = oracle::collapse(plain_tree, ends.a, ends.b);
      EXPECT_TRUE(judged.valid) << ends.a << "-" << ends.b << ": " << judged.reason;
    }
  });
  EXPECT_GT(accepted, 0U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CollapseVerdicts,
                         testing::Values(oracle::TreeKind::kCurve, oracle::TreeKind::kTwoCurves,
                                         oracle::TreeKind::kUv, oracle::TreeKind::kUvPatch,
                                         oracle::TreeKind::kUvRootSeam, oracle::TreeKind::kUvSeam,
                                         oracle::TreeKind::kCurveOfCurve, oracle::TreeKind::kUvOfUv,
                                         oracle::TreeKind::kCurveOfUv, oracle::TreeKind::kMixed),
                         [](const auto& kind) {
                           std::string name = oracle::to_string(kind.param);
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

// Two copies of one edge that share an end, at the end of a slit: the second copy is judged after the first.
TEST(SecondCopy, IsJudgedAgainAfterTheFirstWasCollapsed) {
  std::size_t late = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const auto t = random_small_tree(seed, 10);
    for (const Dart e : simplices_of(t->tree->mesh(NodeId::root), 1)) {
      const Transaction undone(*t->tree, {});
      const bool judged = !t->operations->judge(NodeId::root, e).refusal.refused();
      const Outcome o = t->operations->collapse(NodeId::root, e);
      if (!judged || o) continue;
      ++late;
      EXPECT_EQ(o.refusal.check, Check::link_condition);
    }
  }
  RecordProperty("late", static_cast<int>(late));
}

}  // namespace
}  // namespace multimesh::test
