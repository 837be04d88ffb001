// SPDX-License-Identifier: BSD-3-Clause
// What happens to the surface and to curves: nothing, as sets of points.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/geometry/orient3d.hpp"
#include "test/improve/made_domain.hpp"

namespace multimesh {
namespace {

using test::Box;
using test::BoxOptions;
using test::Kept;
using test::make_box;
using test::Vec3;

std::size_t planes_of(const Box& box, const TaggedTetrahedra& t, std::size_t triangle) {
  std::size_t n = 0;
  for (const auto& plane : box.planes) {
    bool in = true;
    for (const Index v : t.triangles.facet(triangle))
      in = in && orient3d(plane[0].data(), plane[1].data(), plane[2].data(), t.points[v].data()) == 0;
    n += in;
  }
  return n;
}

void expect_surface_is_kept(const Box& box, const TetDomain& domain) {
  const TaggedTetrahedra t = domain.tagged();
  for (std::size_t f = 0; f < t.triangles.size(); ++f) EXPECT_EQ(planes_of(box, t, f), 1);
  for (const Vec3& corner : box.corners)
    EXPECT_NE(
        std::find(t.points.begin(), t.points.end(), std::array<double, 3>{corner[0], corner[1], corner[2]}),
        t.points.end());
}

/// Skewed, with integer coefficients: coordinates and their means stay exact.
Eigen::Matrix3d skew() {
  Eigen::Matrix3d m;
  m << 2, 1, 0, -1, 2, 1, 1, 0, 3;
  return m;
}

TEST(ImproveSurface, StaysInItsPlanesExactly) {
  for (const Eigen::Matrix3d& map : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), skew()})
    for (unsigned seed = 1; seed <= 3; ++seed) {
      BoxOptions options;
      options.squash = 0.9999;
      options.map = map;
      options.seed = seed;
      const Box box = make_box(options);
      TetDomain domain(box.input);
      const Kept kept(domain);
      DomainImproveOptions improve_options;
      improve_options.target_amips = 5;  // hard: the surface has to be worked on
      improve_options.max_passes = 4;
      improve_options.surface_splits = SurfaceSplits::exact;
      improve(domain, improve_options);
      expect_surface_is_kept(box, domain);
      EXPECT_EQ(kept.fault(domain), "") << seed;
    }
}

TEST(ImproveSurface, OfAThinPlateIsRefinedAndExchanged) {
  BoxOptions options;
  options.n = 2;
  options.sheet = options.curve = options.regions = false;
  options.squash = 0;
  options.map.diagonal() << 16, 16, 1;  // faces 8 x 8 x 0.5
  const Box box = make_box(options);
  TetDomain domain(box.input);
  const Kept kept(domain);
  const ImproveResult r = improve(domain);
  EXPECT_GT(r.before.max_amips, 15);
  EXPECT_TRUE(r.target_reached) << r.after.max_amips;
  EXPECT_EQ(kept.fault(domain), "");
  expect_surface_is_kept(box, domain);
}

// As files with decimal coordinates have them: walls are plane and edges straight up to rounding only.
TEST(ImproveSurface, OfATurnedPlateIsRefinedAndExchangedUpToRounding) {
  for (const double angle : {0.1, 0.7}) {
    BoxOptions options;
    options.n = 2;
    options.sheet = options.curve = options.regions = false;
    options.squash = 0;
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
    options.map = turn * Vec3(16.1, 15.9, 1).asDiagonal();
    TetDomain domain(make_box(options).input);
    const Kept kept(domain);
    const ImproveResult r = improve(domain);
    EXPECT_GT(r.before.max_amips, 15);
    EXPECT_TRUE(r.target_reached) << r.after.max_amips;
    EXPECT_EQ(kept.fault(domain), "");
  }
}

TEST(ImproveSurface, IsNotSplitIfThatIsForbidden) {
  BoxOptions options;
  options.squash = 0.9999;
  const Box box = make_box(options);
  TetDomain domain(box.input);
  const Kept kept(domain);
  DomainImproveOptions improve_options;
  improve_options.target_amips = 4;
  improve_options.max_passes = 3;
  improve_options.surface_splits = SurfaceSplits::none;
  improve(domain, improve_options);
  EXPECT_LE(domain.tagged().triangles.size(), box.input.triangles.size());
  expect_surface_is_kept(box, domain);
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveSurface, OfACurvedSurfaceKeepsItsVertices) {
  // A box bent by a parabola: nothing is flat, so that every vertex of the surface has to stay.
  BoxOptions options;
  options.squash = 0.5;
  options.sheet = options.curve = options.regions = false;
  Box box = make_box(options);
  for (auto& p : box.input.points) {
    const double x = p[0], y = p[1];
    p[2] += 0.3 * x * x + 0.2 * y * y;
    p[0] += 0.1 * p[2] * p[2];
    p[1] += 0.13 * p[2] * x;
  }
  TetDomain domain(box.input);
  ASSERT_TRUE(test::all_positive(domain));
  const Kept kept(domain);
  DomainImproveOptions improve_options;
  improve_options.surface_splits = SurfaceSplits::none;
  const ImproveResult r = improve(domain, improve_options);
  EXPECT_TRUE(r.target_reached) << r.after.max_amips;
  const TaggedTetrahedra after = domain.tagged();
  std::set<std::array<double, 3>> surface;
  for (const Index v : box.input.triangles.corners) surface.insert(box.input.points[v]);
  for (const Index v : after.triangles.corners) EXPECT_TRUE(surface.contains(after.points[v]));
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveSurface, LockedPointsKeepTheirPlaces) {
  BoxOptions options;
  options.squash = 0.999;
  Box box = make_box(options);
  for (Index v = 0; v < box.input.points.size(); v += 3) box.input.fixed.push_back(v);
  TetDomain domain(box.input);
  const Kept kept(domain);
  improve(domain, {{.target_amips = 5, .max_passes = 3}, {}});
  const TaggedTetrahedra after = domain.tagged();
  for (const Index v : box.input.fixed)
    EXPECT_NE(std::find(after.points.begin(), after.points.end(), box.input.points[v]), after.points.end());
  EXPECT_EQ(kept.fault(domain), "");
}

// Two faces at 1 degree: no mesh can do without a tetrahedron that is at most that wide.
TEST(ImproveSurface, SaysWhatItForces) {
  TaggedTetrahedra t;
  const double angle = M_PI / 180;
  t.points = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0.5}, {std::cos(angle), std::sin(angle), 0.5}};
  t.tets.corners = {0, 2, 3, 1};
  t.tets.vertices = 4;
  TetDomain domain(t);
  DomainImproveOptions options;
  options.max_passes = 3;
  const ImproveResult r = improve(domain, options);
  EXPECT_FALSE(r.target_reached);
  EXPECT_GE(r.after.max_amips, r.least_max_amips * (1 - 1e-9));
  EXPECT_GT(r.least_max_amips, 30);
  EXPECT_EQ(Vec3(r.least_max_amips_at.data())[0], 0);
  EXPECT_FALSE(r.obstacles.empty());
}

}  // namespace
}  // namespace multimesh
