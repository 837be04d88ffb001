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

/// Faces that bend by less than the feature angle need not stay plane: what is nearly the same counts as
/// such.
FlatListFacts without_small_changes(FlatListFacts after, const FlatListFacts& before) {
  const auto near = [](double x, double y) { return std::abs(x - y) < 1e-3 * std::abs(y); };
  if (near(after.boundary_area, before.boundary_area)) after.boundary_area = before.boundary_area;
  for (auto& [region, volume] : after.volumes)
    if (const auto was = before.volumes.find(region);
        was != before.volumes.end() && near(volume, was->second))
      volume = was->second;
  return after;
}

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
    const FlatListFacts before = facts_of(list);
    EXPECT_EQ(compare(before, without_small_changes(facts_of(domain.tagged()), before)), "")
        << "seed " << seed;
    EXPECT_TRUE(all_positive(domain)) << "seed " << seed;
  }
  EXPECT_GT(with_copies, 20U);
  EXPECT_GT(changed, 50U);
}

}  // namespace
}  // namespace multimesh::test
