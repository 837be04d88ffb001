// SPDX-License-Identifier: BSD-3-Clause
// The surface inside tetrahedra is remeshed, and everything around and on it follows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/algorithms/remesh_domain.hpp"
#include "multimesh/validate.hpp"
#include "test/improve/domain_contract.hpp"
#include "test/improve/made_domain.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;

DomainRemeshOptions with_length(double length) {
  DomainRemeshOptions o;
  o.length = length;
  o.iterations = 6;
  return o;
}

class RemeshBox : public testing::TestWithParam<double> {};

// All its faces are plane and all its lines straight: whatever the mesh, volumes, areas and lengths are the
// same.
TEST_P(RemeshBox, KeepsRegionsPatchesAndCurves) {
  Eigen::Matrix3d sheared = Eigen::Matrix3d::Identity();
  sheared(0, 1) = 0.3;
  for (const bool shear : {false, true})
    for (const double squash : {0.0, 0.9}) {
      SCOPED_TRACE(std::to_string(shear) + " " + std::to_string(squash));
      BoxOptions options;
      options.squash = squash;
      if (shear) options.map = sheared;
      TetDomain domain(make_box(options).input);
      const Kept kept(domain);
      const DomainRemeshResult r = remesh(domain, with_length(GetParam()));
      EXPECT_EQ(kept.fault(domain), "");
      EXPECT_TRUE(all_positive(domain));
      EXPECT_EQ(validate(domain.tree()), Problems{});
      EXPECT_GT(r.surface.moves, 0U);
      // Where a curve ends inside a face, and lines cross, vertices cannot be chosen.
      EXPECT_GT(static_cast<double>(r.surface.edges_in_range), 0.75 * static_cast<double>(r.surface.edges));
    }
}
INSTANTIATE_TEST_SUITE_P(Lengths, RemeshBox, testing::Values(0.06, 0.12, 0.2),
                         [](const auto& i) { return "Percent" + std::to_string(int(100 * i.param + 0.5)); });

TEST(RemeshDomain, GivesCurvedRegionsTheirVolumesBack) {
  TaggedTetrahedra input = make_box({.n = 8, .sheet = false, .curve = false, .squash = 0.5}).input;
  for (auto& [x, y, z] : input.points) {  // bent along all axes
    x += 0.1 * std::sin(3 * y) * std::cos(2 * z);
    y += 0.1 * std::sin(4 * z);
    z += 0.08 * std::sin(5 * x);
  }
  TetDomain domain(input);
  const DomainReport before = report(domain);
  const DomainRemeshResult r = remesh(domain, with_length(0.2));
  const DomainReport after = report(domain);
  EXPECT_LT(after.surface->faces, before.surface->faces);
  for (const auto& [region, of] : before.regions)
    EXPECT_NEAR(after.regions.at(region).volume, of.volume, 1e-8 * of.volume) << region;
  EXPECT_TRUE(all_positive(domain));
  EXPECT_EQ(validate(domain.tree()), Problems{});
  EXPECT_GT(r.surface.moves, 0U);
}

void remesh_all(TetDomain& domain, const DomainLocks& locks) {
  DomainRemeshOptions options = with_length(0.11);
  static_cast<DomainLocks&>(options) = locks;
  (void)remesh(domain, options);
}

TEST(RemeshDomain, LockedPatchesKeepTheirTriangles) {
  expect_locked_patches_keep_their_triangles(remesh_all);
}
TEST(RemeshDomain, LockedRegionsKeepTheirTetrahedra) {
  expect_locked_regions_keep_their_tetrahedra(remesh_all);
}
TEST(RemeshDomain, RequiredTrianglesStay) {
  expect_required_triangles_stay(remesh_all);
}
TEST(RemeshDomain, ADomainWithoutSurfaceIsRefused) {
  expect_a_domain_without_surface_is_refused(remesh_all);
}
TEST(RemeshDomain, GivesTheSameTwice) {
  expect_the_same_twice(remesh_all);
}

}  // namespace
}  // namespace multimesh::test
