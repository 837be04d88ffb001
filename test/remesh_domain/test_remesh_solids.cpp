// SPDX-License-Identifier: BSD-3-Clause
// Solids that touch themselves in points and edges: after remeshing of their surface, and joined again, they
// have the same topology.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "multimesh/algorithms/remesh_domain.hpp"
#include "test/improve/flat_list_check.hpp"
#include "test/improve/made_domain.hpp"
#include "test/improve/random_solid.hpp"

namespace multimesh::test {
namespace {

/// Of areas and volumes: faces that bend by less than the feature angle need not stay plane.
constexpr double tolerance = 1e-3;

TEST(RemeshSolids, StayWhatTheyAreWhenJoinedAgain) {
  std::size_t with_copies = 0, changed = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const TaggedTetrahedra list = RandomSolid(seed).list();
    TetDomainOptions sharp;
    sharp.feature_angle = std::numbers::pi / 180;  // each of its faces is plane
    TetDomain domain(list, sharp);
    with_copies += domain.report().copied_vertices > 0;
    DomainRemeshOptions options;
    options.length = 0.3 + 0.1 * (seed % 6);
    options.iterations = 3;
    const DomainRemeshResult r = remesh(domain, options);
    changed += r.surface.splits + r.surface.collapses + r.surface.swaps + r.surface.moves > 0;
    EXPECT_EQ(compare(facts_of(list), facts_of(domain.tagged()), tolerance), "") << "seed " << seed;
    EXPECT_TRUE(all_positive(domain)) << "seed " << seed;
  }
  EXPECT_GT(with_copies, 20U);
  EXPECT_GT(changed, 50U);
}

}  // namespace
}  // namespace multimesh::test
