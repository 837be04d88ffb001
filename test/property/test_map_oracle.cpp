// SPDX-License-Identifier: BSD-3-Clause
// Every map, rebuilt by brute force: operations are repeated on plain vertex sets using only identification
// and subdivision, and the real tree must be the same up to the names of new vertices.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>

#include "oracle/image.hpp"
#include "oracle/image_signature.hpp"
#include "oracle/random_solid_trees.hpp"
#include "property/shadow.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

/// Operations per kind of tree: MULTIMESH_ORACLE_OPERATIONS, for long runs by hand.
std::size_t operations_per_kind() {
  const char* given = std::getenv("MULTIMESH_ORACLE_OPERATIONS");
  return given ? std::strtoull(given, nullptr, 10) : 1500;
}

struct Count {
  std::size_t splits = 0, collapses = 0, swaps = 0, face_swaps = 0, insertions = 0, refused = 0;

  void add(const Shadow& s) {
    splits += s.splits, collapses += s.collapses, swaps += s.swaps, refused += s.refused;
    face_swaps += s.face_swaps, insertions += s.insertions;
  }
  /// Curves have no swaps.
  void report(bool with_swaps = true) const {
    std::printf("splits %zu, collapses %zu, swaps %zu, face swaps %zu, insertions %zu, refused %zu\n", splits,
                collapses, swaps, face_swaps, insertions, refused);
    testing::Test::RecordProperty("splits", static_cast<int>(splits));
    testing::Test::RecordProperty("collapses", static_cast<int>(collapses));
    testing::Test::RecordProperty("swaps", static_cast<int>(swaps));
    testing::Test::RecordProperty("refused", static_cast<int>(refused));
    EXPECT_GT(10 * splits, refused) << "nearly everything was refused: the test says little";
    EXPECT_GT(10 * collapses, refused);
    EXPECT_TRUE(!with_swaps || 100 * swaps > refused);
  }
};

void run(MultiMesh& tree, std::uint64_t seed, std::size_t operations, Count& count) {
  Shadow shadow(tree, seed);
  for (std::size_t i = 0; i < operations; ++i) ASSERT_EQ(shadow.step(), "") << "operation " << i;
  count.add(shadow);
}

/// Every stratum has a mesh: no operation may change the place of any mesh in its ancestors
/// (guards: docs/concepts.md#when-a-collapse-is-legal).
bool is_guarded(oracle::TreeKind kind) {
  switch (kind) {
    case oracle::TreeKind::kUv:
    case oracle::TreeKind::kUvPatch:
    case oracle::TreeKind::kUvOfUv:
    case oracle::TreeKind::kCurveOfUv:
    case oracle::TreeKind::kPointsOfUv:
      return false;
    default:
      return true;
  }
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
    const oracle::SignatureOptions options{false, false};
    const oracle::TreeSignature before = image_signature(plain, options);
    run(*tree, seed, each, count);
    if (HasFatalFailure()) return;
    if (is_guarded(kind)) {
      EXPECT_EQ(difference(before, image_signature(to_oracle(*tree), options)), "");
    }
  }
  count.report();
}

class MapOracleInSolids : public testing::TestWithParam<int> {};

// Everything that is guaranteed for collapses is guaranteed for swaps, which end with one.
TEST_P(MapOracleInSolids, RandomPlainTreesEqualBruteForceAfterEachOperation) {
  const auto kind = static_cast<oracle::SolidTreeKind>(GetParam());
  const bool is_guarded =
      kind == oracle::SolidTreeKind::kCurve || kind == oracle::SolidTreeKind::kSurfaceGuarded ||
      kind == oracle::SolidTreeKind::kSurfacesGuarded || kind == oracle::SolidTreeKind::kPoints;
  Count count;
  const std::size_t each = 50;
  for (std::uint64_t seed = 0; seed < operations_per_kind() / each / 2; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 rng(seed);
    const oracle::Tree plain = oracle::random_solid_tree(seed, kind, static_cast<oracle::Solid>(seed % 4));
    auto tree = to_multimesh(plain, rng);
    ASSERT_TRUE(tree);
    ASSERT_EQ(oracle::tree_error(to_oracle(*tree)), "");
    ASSERT_EQ(query_difference(*tree, to_oracle(*tree)), "");
    const oracle::SignatureOptions options{false, false};
    const oracle::TreeSignature before = image_signature(plain, options);
    run(*tree, seed, each, count);
    if (HasFatalFailure()) return;
    const oracle::TreeSignature after = image_signature(to_oracle(*tree), options);
    for (std::size_t i = 0; i < before.parts.size(); ++i) {
      const oracle::SignaturePart& part = before.parts[i];
      const bool kept = is_guarded || part.host < 0 ||
                        (part.host == 0 && part.aspect != oracle::SignaturePart::Aspect::kGraph);
      EXPECT_TRUE(!kept || part == after.parts[i]) << oracle::difference({{part}}, {{after.parts[i]}});
    }
  }
  count.report();
  EXPECT_GT(count.face_swaps, 0U);
  EXPECT_GT(count.insertions, 0U);
}

INSTANTIATE_TEST_SUITE_P(Kinds, MapOracleInSolids, testing::Range(0, oracle::kNumberOfSolidTreeKinds),
                         [](const auto& info) {
                           std::string name =
                               oracle::to_string(static_cast<oracle::SolidTreeKind>(info.param));
                           std::erase_if(name,
                                         [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
                           return name;
                         });

INSTANTIATE_TEST_SUITE_P(Kinds, MapOracle, testing::Range(0, oracle::kNumberOfTreeKinds),
                         [](const auto& info) {
                           std::string name = oracle::to_string(static_cast<oracle::TreeKind>(info.param));
                           std::erase_if(name,
                                         [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
                           return name;
                         });

class MapOracleOnGrids : public testing::TestWithParam<TreeKind> {};

TEST_P(MapOracleOnGrids, EqualBruteForceAfterEachOperation) {
  Count count;
  // Brute force on the 3-torus takes its time.
  const std::size_t each = GetParam().name == "Torus3Tile" ? 10 : 100;
  const std::size_t runs = std::max<std::size_t>(1, operations_per_kind() * each / 10'000);
  for (unsigned seed = 0; seed < runs; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto tree = GetParam().make(24, seed);
    ASSERT_EQ(oracle::tree_error(to_oracle(*tree->tree)), "");
    run(*tree->tree, seed, each, count);
    if (HasFatalFailure()) return;
  }
  if (each == 100) count.report(GetParam().make(24, 0)->tree->mesh(NodeId::root).dimension() > 1);
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
