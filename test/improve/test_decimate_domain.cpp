// SPDX-License-Identifier: BSD-3-Clause
// The surface inside tetrahedra is decimated, and all that it lies in and carries goes along.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "multimesh/algorithms/decimate_domain.hpp"
#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/validate.hpp"
#include "test/improve/flat_list_check.hpp"
#include "test/improve/made_domain.hpp"
#include "test/improve/random_solid.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;
using Triangle = std::array<std::array<double, 3>, 3>;

DomainDecimateOptions to_faces(std::size_t faces) {
  DomainDecimateOptions o;
  o.faces = faces;
  return o;
}

/// The triangles with a tag, by their points.
std::set<Triangle> triangles_of_patch(const TaggedTetrahedra& t, TetDomain::Tag tag) {
  std::set<Triangle> all;
  for (std::size_t i = 0; i < t.triangles.size(); ++i) {
    if (t.patches[i] != tag) continue;
    const auto v = t.triangles.facet(i);
    Triangle p{t.points[v[0]], t.points[v[1]], t.points[v[2]]};
    std::ranges::sort(p);
    all.insert(p);
  }
  return all;
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

TEST(DecimateDomain, LockedPatchesKeepTheirTriangles) {
  const Box box = make_box({});
  TetDomain domain(box.input);
  DomainDecimateOptions options = to_faces(1);
  options.locked_patches = {11, 3};
  const DecimateResult r = decimate(domain, options).surface;
  for (const RefusalCount& refused : r.refused)
    EXPECT_NE(refused.reason, "locked patches and regions stay") << "tried in vain";
  const TaggedTetrahedra after = domain.tagged();
  for (const TetDomain::Tag tag : options.locked_patches)
    EXPECT_EQ(triangles_of_patch(after, tag), triangles_of_patch(TetDomain(box.input).tagged(), tag)) << tag;
  EXPECT_LT(triangles_of_patch(after, 12).size(), triangles_of_patch(box.input, 12).size());
}

TEST(DecimateDomain, RequiredTrianglesStay) {
  Box box = make_box({});
  box.input.triangle_flags.assign(box.input.triangles.size(), 0);
  for (std::size_t i = 0; i < box.input.triangles.size(); ++i)
    if (box.input.patches[i] == 14) box.input.triangle_flags[i] = required_simplex;
  TetDomain domain(box.input);
  EXPECT_GT(decimate(domain, to_faces(1)).surface.collapsed, 0U);
  EXPECT_EQ(triangles_of_patch(domain.tagged(), 14), triangles_of_patch(box.input, 14));
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

TEST(DecimateDomain, ADomainWithoutSurfaceIsRefused) {
  TetDomainOptions none;
  none.boundary = none.interfaces = false;
  BoxOptions plain;
  plain.sheet = plain.curve = false;
  TaggedTetrahedra input = make_box(plain).input;
  input.triangles = FacetList{2, 0, {}};
  input.patches.clear();
  TetDomain domain(input, none);
  EXPECT_THROW((void)decimate(domain, to_faces(10)), InputError);
}

TEST(DecimateDomain, GivesTheSameTwice) {
  const auto run = [] {
    TetDomain domain(make_box({}).input);
    (void)decimate(domain, to_faces(100));
    return domain.tagged();
  };
  const TaggedTetrahedra a = run(), b = run();
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tets.corners, b.tets.corners);
}

/// Of areas and volumes: roundings aside.
constexpr double tolerance = 1e-6;

// Cubes or single tetrahedra of a grid that touch themselves in points and edges: many of their edges are in
// several sheets.
TEST(DecimateSolids, StayWhatTheyAreWhenJoinedAgain) {
  std::size_t with_copies = 0, changed = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const TaggedTetrahedra list = RandomSolid(seed).list();
    TetDomainOptions sharp;
    sharp.feature_angle = std::numbers::pi / 180;  // each of its faces is plane
    TetDomain domain(list, sharp);
    with_copies += domain.report().copied_vertices > 0;
    changed += decimate(domain, to_faces(1)).surface.collapsed > 0;
    EXPECT_EQ(compare(facts_of(list), facts_of(domain.tagged()), tolerance), "") << "seed " << seed;
    EXPECT_TRUE(all_positive(domain)) << "seed " << seed;
    EXPECT_EQ(validate(domain.tree()), Problems{}) << "seed " << seed;
  }
  EXPECT_GT(with_copies, 20U);
  EXPECT_GT(changed, 10U);
}

}  // namespace
}  // namespace multimesh::test
