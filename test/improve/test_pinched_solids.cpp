// SPDX-License-Identifier: BSD-3-Clause
// Solids that touch themselves in points and edges: improved, and joined again, they are what they were.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "multimesh/algorithms/improve.hpp"
#include "test/improve/flat_list_check.hpp"
#include "test/improve/random_solid.hpp"

namespace multimesh::test {
namespace {

unsigned solids() {
  const char* asked = std::getenv("MULTIMESH_PINCHED_SOLIDS");
  return asked ? static_cast<unsigned>(std::strtoul(asked, nullptr, 10)) : 40;
}

TEST(PinchedSolids, StayWhatTheyAreWhenJoinedAgain) {
  std::size_t with_copies = 0;
  for (unsigned seed = 0; seed < solids(); ++seed) {
    const TaggedTetrahedra list = RandomSolid(seed).list();
    TetDomain domain(list);
    with_copies += domain.report().copied_vertices > 0;
    std::mt19937 random(seed);
    DomainImproveOptions options;
    options.target_amips = 4 + static_cast<double>(random() % 7);
    if (random() % 2) options.edge_length = 0.5 + static_cast<double>(random() % 100) / 150;
    options.max_passes = 2;
    options.max_growth = 2;
    improve(domain, options);
    EXPECT_EQ(compare(facts_of(list), facts_of(domain.tagged())), "") << "seed " << seed;
  }
  EXPECT_GT(3 * with_copies, solids()) << "at least a third of the solids are pinched";
}

}  // namespace
}  // namespace multimesh::test
