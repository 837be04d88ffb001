// SPDX-License-Identifier: BSD-3-Clause
// Thousands of random operations on all meshes of made tiles.
#include <gtest/gtest.h>

#include "test/periodic/betti.hpp"
#include "test/periodic/periodic_storm.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

struct Kind {
  const char* name;
  PeriodicTile tile;
  PeriodicOptions options;
  bool children;
  friend void PrintTo(const Kind& k, std::ostream* out) { *out << k.name; }
};

class PeriodicStormTest : public testing::TestWithParam<std::tuple<Kind, bool>> {};

TEST_P(PeriodicStormTest, KeepsMapsTopologyAndPeriods) {
  const auto& [kind, shape] = GetParam();
  PeriodicDomain domain(kind.tile, kind.options);
  if (kind.children) {
    domain.add_surface();
    domain.add_cuts();
  }
  std::vector<std::vector<long>> at_start;
  for (const NodeId n : domain.tree().nodes()) at_start.push_back(betti(domain.tree().mesh(n)));
  const unsigned seed = 20240607;
  PeriodicStorm storm(domain, seed, shape);
  for (int i = 1; i <= 4000; ++i) {
    storm.step();
    if (i % 100 == 0) {
      ASSERT_EQ(storm.fault(), "") << "step " << i << ", seed " << seed;
    }
    if (i % 1000 == 0) {
      std::size_t m = 0;
      for (const NodeId n : domain.tree().nodes())
        ASSERT_EQ(betti(domain.tree().mesh(n)), at_start[m++]) << "step " << i << ", mesh " << index(n);
    }
  }
  EXPECT_GT(storm.done, 600U);
  std::cout << storm.done << " done, " << storm.refused << " refused, mismatch " << domain.mismatch() << '\n';
}

INSTANTIATE_TEST_SUITE_P(
    All, PeriodicStormTest,
    testing::Combine(testing::Values(Kind{"torus", square_tile(6, 5), along(true, true, false), false},
                                     Kind{"torusWithCuts", square_tile(6, 5), along(true, true, false), true},
                                     Kind{"cylinder", square_tile(6, 5), along(true, false, false), true},
                                     Kind{"refinedSquare", square_tile(1, 1), along(true, true, false, true),
                                          true},
                                     Kind{"torus3", cube_tile(4), along(true, true, true), false},
                                     Kind{"torus3WithCuts", cube_tile(4), along(true, true, true), true},
                                     Kind{"slab", cube_tile(4), along(true, true, false), true},
                                     Kind{"rod", cube_tile(3), along(false, false, true), true},
                                     Kind{"refinedCube", cube_tile(1), along(true, true, true, true), false}),
                     testing::Bool()),
    [](const auto& i) {
      return std::string(std::get<0>(i.param).name) + (std::get<1>(i.param) ? "WithShape" : "");
    });

}  // namespace
}  // namespace multimesh::test
