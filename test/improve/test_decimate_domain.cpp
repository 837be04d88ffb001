// SPDX-License-Identifier: BSD-3-Clause
// The surface inside tetrahedra is decimated, and all that it lies in and carries goes along.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "multimesh/algorithms/decimate_domain.hpp"
#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/validate.hpp"
#include "test/improve/domain_contract.hpp"
#include "test/improve/made_domain.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;

DomainDecimateOptions to_faces(std::size_t faces) {
  DomainDecimateOptions o;
  o.faces = faces;
  return o;
}

/// Where planes are not exact, as sheared ones are, places in them are found up to the precision of what is
/// remembered of the input, which is single.
void expect_same(const DomainReport& before, const DomainReport& after) {
  ASSERT_EQ(after.regions.size(), before.regions.size());
  for (const auto& [tag, region] : before.regions)
    EXPECT_NEAR(after.regions.at(tag).volume, region.volume, 1e-6 * region.volume) << "region " << tag;
  for (const auto& [x, y] :
       {std::pair(before.surface, after.surface), std::pair(before.curves, after.curves)}) {
    ASSERT_TRUE(x && y);
    EXPECT_EQ(y->components, x->components);
    EXPECT_EQ(y->euler_characteristic, x->euler_characteristic);
    EXPECT_EQ(y->boundary, x->boundary);
  }
  for (const auto& [tag, triangles] : before.patches) EXPECT_TRUE(after.patches.contains(tag)) << tag;
  for (const auto& [tag, edges] : before.curve_tags) EXPECT_TRUE(after.curve_tags.contains(tag)) << tag;
}

class DecimateBox : public testing::TestWithParam<double> {};

// All its faces are plane and all its lines straight: whatever the mesh, volumes, areas and lengths are the
// same.
TEST_P(DecimateBox, KeepsRegionsPatchesAndCurves) {
  Eigen::Matrix3d sheared = Eigen::Matrix3d::Identity();
  sheared(0, 1) = 0.3;
  for (const bool shear : {false, true})
    for (const double squash : {0.0, 0.9}) {
      SCOPED_TRACE(std::to_string(shear) + " " + std::to_string(squash));
      BoxOptions box;
      box.n = 6;
      box.squash = squash;
      if (shear) box.map = sheared;
      TetDomain domain(make_box(box).input);
      const Kept kept(domain);
      const DomainReport before = report(domain);
      const std::size_t tets = domain.tagged().tets.size();
      const auto faces = domain.tagged().triangles.size();
      DomainDecimateOptions options = to_faces(
          std::max<std::size_t>(1, static_cast<std::size_t>(GetParam() * static_cast<double>(faces))));
      options.passes_at_end = shear ? 10 : 0;
      const DomainDecimateResult r = decimate(domain, options);
      if (!shear) {
        EXPECT_EQ(kept.fault(domain), "");
      }
      EXPECT_TRUE(all_positive(domain));
      expect_same(before, report(domain));
      EXPECT_EQ(validate(domain.tree()), Problems{});
      EXPECT_EQ(r.tetrahedra.has_value(), shear);
      EXPECT_LT(domain.tagged().tets.size(), tets);
      if (GetParam() >= 0.5) {
        EXPECT_EQ(r.surface.stop, DecimateResult::Stop::faces);
      }
      EXPECT_LT(static_cast<double>(r.surface.faces_after), 0.5 * static_cast<double>(faces) + 1);
    }
}
INSTANTIATE_TEST_SUITE_P(Ratios, DecimateBox, testing::Values(0.5, 0.0),
                         [](const auto& i) { return i.param > 0 ? "Half" : "AsFewAsItAllows"; });

/// To as few faces as the box allows.
void decimate_all(TetDomain& domain, const DomainLocks& locks) {
  DomainDecimateOptions options = to_faces(1);
  static_cast<DomainLocks&>(options) = locks;
  const DecimateResult r = decimate(domain, options).surface;
  EXPECT_GT(r.collapsed, 0U);
  for (const RefusalCount& refused : r.refused)
    EXPECT_NE(refused.reason, "locked patches and regions stay") << "tried in vain";
}

TEST(DecimateDomain, LockedPatchesKeepTheirTriangles) {
  expect_locked_patches_keep_their_triangles(decimate_all);
}
TEST(DecimateDomain, LockedRegionsKeepTheirTetrahedra) {
  expect_locked_regions_keep_their_tetrahedra(decimate_all);
}
TEST(DecimateDomain, RequiredTrianglesStay) {
  expect_required_triangles_stay(decimate_all);
}
TEST(DecimateDomain, ADomainWithoutSurfaceIsRefused) {
  expect_a_domain_without_surface_is_refused(decimate_all);
}
TEST(DecimateDomain, GivesTheSameTwice) {
  expect_the_same_twice(decimate_all);
}

TEST(DecimateDomain, WithoutImprovementInBetweenItGetsStuckSooner) {
  const auto left = [](int passes) {
    TetDomain domain(make_box({.n = 6}).input);
    DomainDecimateOptions options = to_faces(1);
    options.passes_between = passes;
    const std::size_t faces = decimate(domain, options).surface.faces_after;
    EXPECT_TRUE(all_positive(domain));
    return faces;
  };
  EXPECT_LE(left(2), left(0));
}

// Many of their edges are in several sheets.
TEST(DecimateSolids, StayWhatTheyAreWhenJoinedAgain) {
  const auto run = [](TetDomain& domain, unsigned) {
    const DecimateResult r = decimate(domain, to_faces(1)).surface;
    return r.collapsed > 0;
  };
  expect_solids_stay_what_they_are(run, 1e-6, 10);
}

}  // namespace
}  // namespace multimesh::test
