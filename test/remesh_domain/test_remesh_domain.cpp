// SPDX-License-Identifier: BSD-3-Clause
// The surface inside tetrahedra is remeshed, and everything around and on it follows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "multimesh/algorithms/domain_report.hpp"
#include "multimesh/algorithms/remesh_domain.hpp"
#include "multimesh/validate.hpp"
#include "test/improve/made_domain.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;
using Triangle = std::array<std::array<double, 3>, 3>;

DomainRemeshOptions with_length(double length) {
  DomainRemeshOptions o;
  o.length = length;
  o.iterations = 6;
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

TEST(RemeshDomain, LockedPatchesKeepTheirTriangles) {
  const Box box = make_box({});
  TetDomain domain(box.input);
  DomainRemeshOptions options = with_length(0.11);
  options.locked_patches = {11, 3};
  (void)remesh(domain, options);
  const TaggedTetrahedra after = domain.tagged();
  for (const TetDomain::Tag tag : options.locked_patches)
    EXPECT_EQ(triangles_of_patch(after, tag), triangles_of_patch(TetDomain(box.input).tagged(), tag)) << tag;
  EXPECT_NE(triangles_of_patch(after, 12), triangles_of_patch(box.input, 12));
}

TEST(RemeshDomain, LockedRegionsKeepTheirTetrahedra) {
  const Box box = make_box({});
  TetDomain domain(box.input);
  DomainRemeshOptions options = with_length(0.11);
  options.locked_regions = {1};
  (void)remesh(domain, options);
  const auto tets_of_region = [](const TaggedTetrahedra& t) {
    std::multiset<std::array<std::array<double, 3>, 4>> all;
    for (std::size_t i = 0; i < t.tets.size(); ++i) {
      if (t.regions[i] != 1) continue;
      const auto v = t.tets.facet(i);
      std::array<std::array<double, 3>, 4> p{t.points[v[0]], t.points[v[1]], t.points[v[2]], t.points[v[3]]};
      std::ranges::sort(p);
      all.insert(p);
    }
    return all;
  };
  EXPECT_EQ(tets_of_region(domain.tagged()), tets_of_region(box.input));
}

TEST(RemeshDomain, RequiredTrianglesStay) {
  Box box = make_box({});
  box.input.triangle_flags.assign(box.input.triangles.size(), 0);
  for (std::size_t i = 0; i < box.input.triangles.size(); ++i)
    if (box.input.patches[i] == 14) box.input.triangle_flags[i] = required_simplex;
  TetDomain domain(box.input);
  (void)remesh(domain, with_length(0.11));
  EXPECT_EQ(triangles_of_patch(domain.tagged(), 14), triangles_of_patch(box.input, 14));
}

TEST(RemeshDomain, ADomainWithoutSurfaceIsRefused) {
  TetDomainOptions none;
  none.boundary = none.interfaces = false;
  BoxOptions plain;
  plain.sheet = plain.curve = false;
  TaggedTetrahedra input = make_box(plain).input;
  input.triangles = FacetList{2, 0, {}};
  input.patches.clear();
  TetDomain domain(input, none);
  EXPECT_THROW((void)remesh(domain, with_length(0.1)), InputError);
}

TEST(RemeshDomain, GivesTheSameTwice) {
  const auto run = [] {
    TetDomain domain(make_box({}).input);
    (void)remesh(domain, with_length(0.1));
    return domain.tagged();
  };
  const TaggedTetrahedra a = run(), b = run();
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.tets.corners, b.tets.corners);
}

}  // namespace
}  // namespace multimesh::test
