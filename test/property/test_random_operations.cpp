// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "test/support/storm.hpp"

namespace multimesh::test {
namespace {

/// How many operations in total: MULTIMESH_STORM_OPERATIONS, for long runs by hand.
std::size_t operations(std::size_t fallback) {
  const char* given = std::getenv("MULTIMESH_STORM_OPERATIONS");
  return given ? std::strtoull(given, nullptr, 10) : fallback;
}

class RandomOperations : public testing::TestWithParam<TreeKind> {};

Index facets_of_root(const Tree& tree) {
  const Mesh& root = tree.tree->mesh(NodeId::root);
  return root.capacity(root.dimension());
}

TEST_P(RandomOperations, LeaveEveryMapValidOnSmallMeshes) {
  // The smallest 3-torus is not small.
  const std::size_t share = GetParam().name == "Torus3Tile" ? 10 : 1;
  const std::size_t total = operations(30'000) / tree_kinds().size() / share;
  std::size_t tried = 0, done = 0;
  for (unsigned seed = 0; tried < total; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto tree = GetParam().make(24, seed);
    Storm storm(*tree, seed, 16, std::max<Index>(60, facets_of_root(*tree)));
    ASSERT_EQ(storm.fault(), "");
    for (std::size_t i = 0; i < 500; ++i, ++tried) {
      storm.step();
      ASSERT_EQ(storm.fault(), "") << "after operation " << i;
    }
    done += storm.done;
  }
  EXPECT_GT(done, tried / 10) << "nearly everything was refused: the test says little";
  RecordProperty("tried", static_cast<int>(tried));
  RecordProperty("done", static_cast<int>(done));
}

TEST_P(RandomOperations, LeaveEveryMapValidOnLargerMeshes) {
  const std::size_t total = 10 * operations(30'000) / tree_kinds().size();
  std::size_t tried = 0;
  for (unsigned seed = 100; tried < total; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto tree = GetParam().make(2000, seed);
    Storm storm(*tree, seed, 1000, 4000);
    const std::size_t here = std::min<std::size_t>(total / 4 + 1, 50'000);
    for (std::size_t i = 0; i < here; ++i, ++tried) {
      storm.step();
      if (i % 1000 == 999) {
        ASSERT_EQ(storm.fault(), "") << "after operation " << i;
      }
    }
    ASSERT_EQ(storm.fault(), "");
  }
}

INSTANTIATE_TEST_SUITE_P(Trees, RandomOperations, testing::ValuesIn(tree_kinds()),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace multimesh::test
