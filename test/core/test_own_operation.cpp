// SPDX-License-Identifier: BSD-3-Clause
// An operation of your own, as in docs/extending.md: a swap made of a split and a collapse.
#include <gtest/gtest.h>

#include "multimesh/validate.hpp"
#include "test/core/bridge.hpp"
#include "test/support/fingerprint.hpp"

namespace multimesh::test {
namespace {

Outcome own_swap(Propagation& operations, Dart edge) {
  const Mesh& root = operations.tree().mesh(NodeId::root);
  Transaction undone = operations.transaction();
  const Outcome split = operations.split(NodeId::root, edge, 0.5);
  if (!split) return split;
  const Dart to_apex = root.reorder(split.root, permutation(1, 2, 0));  // (a, c, x) -> (c, x, a)
  const Outcome collapse = operations.collapse(NodeId::root, to_apex, Placement::keep_b());
  if (collapse) undone.commit();
  return collapse;
}

TEST(OwnOperation, IsDoneInAllMeshesOrNotAtAll) {
  std::size_t done = 0, refused = 0;
  for (const TreeKind& kind : surface_tree_kinds())
    for (unsigned seed = 0; seed < 3; ++seed) {
      const auto t = kind.make(24, seed);
      SCOPED_TRACE(kind.name);
      for (int i = 0; i < 40; ++i) {
        const DartBuffer darts = all_darts(t->tree->mesh(NodeId::root));
        const Dart edge = darts[static_cast<std::size_t>(i * 37) % darts.size()];
        const auto before = fingerprint(*t);
        if (own_swap(*t->operations, edge)) {
          ++done;
        } else {
          ++refused;
          EXPECT_EQ(fingerprint(*t), before);
        }
        ASSERT_EQ(validate(*t->tree), std::vector<std::string>{});
      }
    }
  EXPECT_GT(done, 100U);
  EXPECT_GT(refused, 10U);
}

}  // namespace
}  // namespace multimesh::test
