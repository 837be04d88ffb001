// SPDX-License-Identifier: BSD-3-Clause
// Solids that touch themselves in points and edges: after remeshing of their surface, and joined again, they
// have the same topology.
#include <gtest/gtest.h>

#include "multimesh/algorithms/remesh_domain.hpp"
#include "test/improve/domain_contract.hpp"

namespace multimesh::test {
namespace {

TEST(RemeshSolids, StayWhatTheyAreWhenJoinedAgain) {
  const auto run = [](TetDomain& domain, unsigned seed) {
    DomainRemeshOptions options;
    options.length = 0.3 + 0.1 * (seed % 6);
    options.iterations = 3;
    const DomainRemeshResult r = remesh(domain, options);
    return r.surface.splits + r.surface.collapses + r.surface.swaps + r.surface.moves > 0;
  };
  // Faces that bend by less than the feature angle need not stay plane.
  expect_solids_stay_what_they_are(run, 1e-3, 50);
}

}  // namespace
}  // namespace multimesh::test
