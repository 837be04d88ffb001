// SPDX-License-Identifier: BSD-3-Clause
// Every map, rebuilt by brute force: operations are repeated on plain vertex sets by nothing but
// identification and subdivision, and the real tree must be the same up to the names of new vertices.
#include <gtest/gtest.h>

#include <cstdlib>

#include "multimesh/validate.hpp"
#include "oracle/image.hpp"
#include "oracle/random_trees.hpp"
#include "property/oracle_tree.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

/// Operations per kind of tree: MULTIMESH_ORACLE_OPERATIONS, for long runs by hand.
std::size_t operations_per_kind() {
  const char* given = std::getenv("MULTIMESH_ORACLE_OPERATIONS");
  return given ? std::strtoull(given, nullptr, 10) : 1500;
}

/// Random operations on a tree, each of them repeated on plain vertex sets.
class Shadow {
 public:
  Shadow(MultiMesh& tree, std::uint64_t seed)
      : tree_(tree), ops_(tree), records_(ops_, tree), rng_(seed), plain_(to_oracle(tree)) {}

  /// One operation. \return what differs from brute force, or an empty string
  std::string step() {
    const NodeId n = tree_.nodes()[oracle::pick(rng_, tree_.nodes().size())];
    const Dart d = random_dart(n);
    const Dart root = tree_.to_root(n, d);
    const Mesh& mesh = tree_.mesh(NodeId::root);
    const int a = static_cast<int>(mesh.vertex(root));
    const int b = static_cast<int>(mesh.vertex(mesh.reorder(root, exchange_ends)));
    records_.clear();
    std::size_t choice = oracle::pick(rng_, 100);
    if (plain_.nodes[0].mesh.facets.size() > 36) choice = 30 + choice / 2;
    if (plain_.nodes[0].mesh.facets.size() < 12) choice /= 2;
    std::string fault = choice < 30   ? split(n, d, a, b)
                        : choice < 75 ? collapse(n, d, a, b)
                                      : swap(n, d, a, b, choice < 90);
    const auto problems = validate(tree_);
    if (fault.empty() && !problems.empty()) fault = problems.front();
    if (fault.empty() && steps_++ % 4 == 0) fault = query_difference(tree_, plain_);
    if (fault.empty() && steps_ % 150 == 0) {
      tree_.compact();
      plain_ = to_oracle(tree_);
      fault = query_difference(tree_, plain_);
    }
    return fault;
  }

  std::size_t splits = 0, collapses = 0, swaps = 0, refused = 0;

 private:
  Dart random_dart(NodeId n) {
    const Mesh& mesh = tree_.mesh(n);
    const int k = mesh.dimension();
    for (;;) {
      const auto f = static_cast<Index>(oracle::pick(rng_, mesh.capacity(k)));
      if (!mesh.is_live(k, f)) continue;
      return mesh.reorder(mesh.dart_of(k, f), {static_cast<std::uint8_t>(oracle::pick(rng_, k == 2 ? 6 : 2))});
    }
  }

  /// Compares with what the tree should be, and goes on from there.
  std::string compare(const oracle::Tree& expected, std::size_t& count) {
    ++count;
    plain_ = to_oracle(tree_);
    return tree_difference(expected, plain_);
  }

  std::string unchanged() { return compare(oracle::Tree(plain_), refused); }

  std::string split(NodeId n, Dart d, int a, int b) {
    const oracle::SplitResult expected = oracle::split(plain_, a, b);
    if (!ops_.split(n, d)) return "a split was refused";
    return compare(renamed(expected.tree, records_.names_after(expected)), splits);
  }

  std::string collapse(NodeId n, Dart d, int a, int b) {
    const oracle::CollapseResult expected = oracle::collapse(plain_, a, b);
    if (!ops_.collapse(n, d)) return unchanged();
    if (!expected.valid) return "a collapse was done that leaves no valid tree: " + expected.reason;
    return compare(renamed(expected.tree, records_.names_after(expected)), collapses);
  }

  // A split, and the collapse of the new vertex into an apex. The names of the new vertices are the largest
  // ones, so that none of them survives. Natively it does not matter which apex; by split and collapse it
  // does on the rim of a patch, which loses a triangle or gains one.
  std::string swap(NodeId n, Dart d, int a, int b, bool natively) {
    if (!(natively ? ops_.swap(n, d) : ops_.swap_by_split_and_collapse(n, d))) return unchanged();
    const oracle::Simplex edge = oracle::simplex({a, b});
    const oracle::SimplexSet apexes = of_dimension(link(simplices(plain_.nodes[0].mesh), edge), 0);
    if (apexes.size() != 2) return "an edge was swapped that has not two facets";
    const oracle::SplitResult cut = oracle::split(plain_, a, b);
    const int apex = natively ? apexes[0].v[0] : static_cast<int>(records_.of(0).back().vertex);
    if (!contains(apexes, oracle::simplex({apex}))) return "a swap that did not end at an apex";
    const auto expected = oracle::collapse(cut.tree, apex, cut.vertex[0].at(edge));
    if (!expected.valid) return "a swap was done that leaves no valid tree: " + expected.reason;
    return compare(expected.tree, swaps);
  }

  MultiMesh& tree_;
  Propagation ops_;
  Records records_;
  std::mt19937_64 rng_;
  oracle::Tree plain_;
  std::size_t steps_ = 0;
};

struct Count {
  std::size_t splits = 0, collapses = 0, swaps = 0, refused = 0;

  void add(const Shadow& s) {
    splits += s.splits, collapses += s.collapses, swaps += s.swaps, refused += s.refused;
  }
  void report() const {
    std::printf("splits %zu, collapses %zu, swaps %zu, refused %zu\n", splits, collapses, swaps, refused);
    EXPECT_GT(splits, 0U);
    EXPECT_GT(collapses, 0U);
    EXPECT_GT(swaps, 0U);
  }
};

void run(MultiMesh& tree, std::uint64_t seed, std::size_t operations, Count& count) {
  Shadow shadow(tree, seed);
  for (std::size_t i = 0; i < operations; ++i) ASSERT_EQ(shadow.step(), "") << "operation " << i;
  count.add(shadow);
}

class MapOracle : public testing::TestWithParam<int> {};

TEST_P(MapOracle, RandomPlainTreesEqualBruteForceAfterEachOperation) {
  const auto kind = static_cast<oracle::TreeKind>(GetParam());
  Count count;
  const std::size_t each = 50;
  for (std::uint64_t seed = 0; seed < operations_per_kind() / each; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 rng(seed);
    const auto surface = static_cast<oracle::Surface>(seed % (oracle::kNumberOfSurfaces - 1));
    const oracle::Tree plain = oracle::random_tree(seed, kind, surface);
    auto tree = to_multimesh(plain, rng);
    ASSERT_TRUE(tree);
    ASSERT_EQ(oracle::tree_error(to_oracle(*tree)), "");
    ASSERT_EQ(query_difference(*tree, to_oracle(*tree)), "");
    run(*tree, seed, each, count);
    if (HasFatalFailure()) return;
  }
  count.report();
}

INSTANTIATE_TEST_SUITE_P(Kinds, MapOracle, testing::Range(0, oracle::kNumberOfTreeKinds), [](const auto& info) {
  std::string name = oracle::to_string(static_cast<oracle::TreeKind>(info.param));
  std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
  return name;
});

class MapOracleOnGrids : public testing::TestWithParam<TreeKind> {};

TEST_P(MapOracleOnGrids, EqualBruteForceAfterEachOperation) {
  Count count;
  const std::size_t each = 100;
  for (unsigned seed = 0; seed < operations_per_kind() / each; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto tree = GetParam().make(24, seed);
    run(*tree->tree, seed, each, count);
    if (HasFatalFailure()) return;
  }
  count.report();
}

INSTANTIATE_TEST_SUITE_P(Trees, MapOracleOnGrids, testing::ValuesIn(tree_kinds()),
                         [](const auto& kind) { return kind.param.name; });

TEST(MapOracleConversion, RefusesASurfaceThatCannotBeOriented) {
  std::mt19937_64 rng(1);
  EXPECT_FALSE(to_multimesh(oracle::random_tree(1, oracle::TreeKind::kUv, oracle::Surface::kMoebius), rng));
}

TEST(MapOracleConversion, ThereAndBackIsTheSameTree) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    std::mt19937_64 rng(seed);
    const oracle::Tree plain = oracle::random_tree(seed);
    const auto tree = to_multimesh(plain, rng);
    if (!tree) continue;  // a Moebius band
    Renaming ranks;
    for (const oracle::TreeNode& node : plain.nodes) {
      ranks.emplace_back();
      for (const int v : vertices(node.mesh)) ranks.back().emplace(v, static_cast<int>(ranks.back().size()));
    }
    EXPECT_EQ(tree_difference(renamed(plain, ranks), to_oracle(*tree)), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace multimesh::test
