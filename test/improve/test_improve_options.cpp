// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/error.hpp"
#include "test/improve/made_domain.hpp"

namespace multimesh {
namespace {

using test::Box;
using test::BoxOptions;
using test::Kept;
using test::make_box;
using test::Vec3;

std::vector<double> edge_lengths(const TetDomain& domain) {
  const TaggedTetrahedra t = domain.tagged();
  std::set<std::pair<Index, Index>> edges;
  for (std::size_t f = 0; f < t.tets.size(); ++f)
    for (const Index a : t.tets.facet(f))
      for (const Index b : t.tets.facet(f))
        if (a < b) edges.insert({a, b});
  std::vector<double> lengths;
  for (const auto& [a, b] : edges)
    lengths.push_back((Vec3(t.points[a].data()) - Vec3(t.points[b].data())).norm());
  std::sort(lengths.begin(), lengths.end());
  return lengths;
}

TEST(ImproveOptions, RefinesToAnEdgeLength) {
  TetDomain domain(make_box({.n = 2, .squash = 0.5}).input);
  const Kept kept(domain);
  const ImproveResult r = improve(domain, {{.edge_length = 0.2}, {}});
  EXPECT_TRUE(r.target_reached) << r.after.max_amips;
  const std::vector<double> lengths = edge_lengths(domain);
  EXPECT_LE(lengths[lengths.size() * 9 / 10], 0.2 * 4 / 3 + 1e-12);
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveOptions, NoEdgeIsLongerThanTheMaximum) {
  for (const double target : {0.0, 0.25}) {
    TetDomain domain(make_box({.n = 2, .squash = 0.5}).input);
    const Kept kept(domain);
    const std::size_t before = edge_lengths(domain).size();
    ImproveOptions options;
    options.max_edge_length = 0.28;
    options.edge_length = target;
    const ImproveResult r = improve(domain, {options, {}});
    EXPECT_LE(edge_lengths(domain).back(), 0.28);
    EXPECT_EQ(r.lengths.longest, edge_lengths(domain).back());
    EXPECT_GT(edge_lengths(domain).size(), before);
    EXPECT_TRUE(r.target_reached) << r.after.max_amips;
    EXPECT_EQ(kept.fault(domain), "");
  }
}

TEST(SplitLongEdges, LeavesNoneAboveTheLength) {
  Eigen::Matrix3d oblique;
  oblique << 1, 0.3, -0.2, 0.1, 0.7, 0.4, -0.3, 0.2, 1.3;
  for (const Eigen::Matrix3d& map : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), oblique})
    for (const double length : {0.11, 0.3, 0.9}) {
      TetDomain domain(make_box({.n = 2, .map = map, .squash = 0.9}).input);
      const Kept kept(domain);
      split_long_edges(domain, length);
      EXPECT_LE(edge_lengths(domain).back(), length);
      EXPECT_TRUE(test::all_positive(domain));
      EXPECT_EQ(kept.fault(domain), "") << length;
      EXPECT_EQ(split_long_edges(domain, length), 0U);
    }
}

TEST(SplitLongEdges, LeavesWhatIsLocked) {
  const Box box = make_box({.n = 2, .squash = 0.5});
  TetDomain domain(box.input);
  const Kept kept(domain);
  EXPECT_GT(split_long_edges(domain, 0.4, {{}, {}, true}), 0U);
  EXPECT_EQ(domain.tagged().triangles.size(), box.input.triangles.size());
  EXPECT_EQ(kept.fault(domain), "");
  EXPECT_THROW(split_long_edges(domain, 0), InputError);
}

/// The triangles of the surface by the places of their corners.
std::multiset<std::set<std::array<double, 3>>> surface_triangles(const TetDomain& domain) {
  const TaggedTetrahedra t = domain.tagged();
  std::multiset<std::set<std::array<double, 3>>> all;
  for (std::size_t f = 0; f < t.triangles.size(); ++f) {
    std::set<std::array<double, 3>> corners;
    for (const Index v : t.triangles.facet(f)) corners.insert(t.points[v]);
    all.insert(corners);
  }
  return all;
}

TEST(ImproveOptions, AFixedSurfaceKeepsItsTriangles) {
  const Box box = make_box({.n = 4});
  TetDomain domain(box.input), other(box.input);
  const auto before = surface_triangles(domain);
  multimesh::improve(domain, {{.target_amips = 8}, {}, /* lock_surface */ true});  // a TetDomain
  EXPECT_EQ(surface_triangles(domain), before);
  Embedding embedding = other.embedding();
  const NodeId node = NodeId::root, surface = *other.surface();
  multimesh::improve(embedding, node, {.confined = {{surface, multimesh::Confined::fixed}}});
  EXPECT_EQ(surface_triangles(other), before);
  EXPECT_LT(test::max_amips(domain), test::max_amips(TetDomain(box.input)));
  EXPECT_LT(test::max_amips(other), test::max_amips(TetDomain(box.input)));
}

TEST(ImproveOptions, ASurfaceInAnEnvelopeMoves) {
  TetDomain domain(make_box({.n = 4, .map = Eigen::AngleAxisd(1, Vec3(1, 2, 3)).toRotationMatrix()}).input);
  const auto before = surface_triangles(domain);
  Embedding embedding = domain.embedding();
  const NodeId node = NodeId::root, interfaces = *domain.surface();
  multimesh::improve(embedding, node, {.confined = {{interfaces, multimesh::Confined::envelope, 0.05}}});
  EXPECT_NE(surface_triangles(domain), before);
  EXPECT_TRUE(test::all_positive(domain));
}

TEST(ImproveOptions, CoarsensToAnEdgeLength) {
  TetDomain domain(make_box({.n = 8, .sheet = false, .regions = false, .curve = false, .squash = 0.5}).input);
  const Kept kept(domain);
  const ImproveResult r = improve(domain, {{.edge_length = 0.4}, {}});
  EXPECT_TRUE(r.target_reached) << r.after.max_amips;
  EXPECT_LT(r.after.tets, r.before.tets / 3);
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveOptions, DoesNotSplitBelowTheLeastLength) {
  TetDomain domain(make_box({.squash = 0.9999}).input);
  DomainImproveOptions options;
  options.min_edge_length = 10;
  options.target_amips = 4;
  options.max_passes = 3;
  const ImproveResult r = improve(domain, options);
  const auto split = std::find_if(r.operations.begin(), r.operations.end(),
                                  [](const OperationCount& c) { return c.name == "split"; });
  EXPECT_EQ(split->done, 0);
  EXPECT_GT(split->tried, 0);
}

TEST(ImproveOptions, LockedRegionsAreNotTouched) {
  const Box box = make_box({.squash = 0.999});
  const auto tets_of = [](const TaggedTetrahedra& t, TetDomain::Tag region) {
    std::set<std::set<std::array<double, 3>>> tets;
    for (std::size_t f = 0; f < t.tets.size(); ++f) {
      std::set<std::array<double, 3>> points;
      for (const Index v : t.tets.facet(f)) points.insert(t.points[v]);
      if (t.regions[f] == region) tets.insert(points);
    }
    return tets;
  };
  TetDomain domain(box.input);
  const Kept kept(domain);
  DomainImproveOptions options;
  options.locked_regions = {2};
  options.max_passes = 3;
  const ImproveResult r = improve(domain, options);
  EXPECT_EQ(tets_of(domain.tagged(), 2), tets_of(box.input, 2));
  EXPECT_NE(tets_of(domain.tagged(), 1), tets_of(box.input, 1));
  EXPECT_FALSE(r.target_reached);
  ASSERT_FALSE(r.obstacles.empty());
  EXPECT_TRUE(std::any_of(r.obstacles.begin(), r.obstacles.end(),
                          [](const ImproveObstacle& o) { return o.reason == "in a locked region"; }));
  EXPECT_EQ(kept.fault(domain), "");
}

/// The triangles of some patches, or of all, by their points.
std::set<std::set<std::array<double, 3>>> triangles_of(const TaggedTetrahedra& t, TetDomain::Tag patch) {
  std::set<std::set<std::array<double, 3>>> triangles;
  for (std::size_t f = 0; f < t.triangles.size(); ++f) {
    std::set<std::array<double, 3>> points;
    for (const Index v : t.triangles.facet(f)) points.insert(t.points[v]);
    if (patch == 0 || t.patches[f] == patch) triangles.insert(points);
  }
  return triangles;
}

TEST(ImproveOptions, LockedPatchesAndSurfacesKeepTheirTriangles) {
  const Box box = make_box({.squash = 0.9999});
  DomainImproveOptions options;
  options.edge_length = 0.16;
  options.max_passes = 1;
  TetDomain free(box.input);
  improve(free, options);
  EXPECT_NE(triangles_of(free.tagged(), 3), triangles_of(box.input, 3));
  options.locked_patches = {3, 11};
  TetDomain two(box.input);
  improve(two, options);
  for (const TetDomain::Tag patch : {3, 11})
    EXPECT_EQ(triangles_of(two.tagged(), patch), triangles_of(box.input, patch));
  EXPECT_NE(triangles_of(two.tagged(), 12), triangles_of(box.input, 12));
  options.lock_surface = true;
  TetDomain all(box.input);
  const Kept kept(all);
  improve(all, options);
  EXPECT_EQ(triangles_of(all.tagged(), 0), triangles_of(box.input, 0));
  EXPECT_EQ(kept.fault(all), "");
}

TEST(ImproveOptions, RequiredSimplicesStay) {
  Box box = make_box({.squash = 0.9999});
  box.input.triangle_flags.assign(box.input.triangles.size(), 0);
  box.input.edge_flags.assign(box.input.edges.size(), required_simplex);
  for (std::size_t f = 0; f < box.input.triangles.size(); ++f)
    if (box.input.patches[f] == 3) box.input.triangle_flags[f] = required_simplex;
  TetDomain domain(box.input);
  DomainImproveOptions options;
  options.edge_length = 0.16;
  options.max_passes = 1;
  improve(domain, options);
  const TaggedTetrahedra after = domain.tagged();
  EXPECT_EQ(triangles_of(after, 3), triangles_of(box.input, 3));
  const auto required = [](const TaggedTetrahedra& t) {
    std::set<std::set<std::array<double, 3>>> edges;
    for (std::size_t e = 0; e < t.edges.size(); ++e)
      if (t.edge_flags[e] & required_simplex)
        edges.insert({t.points[t.edges.facet(e)[0]], t.points[t.edges.facet(e)[1]]});
    return edges;
  };
  EXPECT_EQ(required(after), required(box.input));
}

TEST(ImproveOptions, TimeAndGrowthEndARun) {
  const Box box = make_box({.squash = 0.9999});
  TetDomain domain(box.input);
  const Kept kept(domain);
  const ImproveResult late = improve(domain, {{.target_amips = 3.1, .time_limit = 1e-9}, {}});
  EXPECT_EQ(late.stop, ImproveStop::time_limit);
  EXPECT_EQ(kept.fault(domain), "");
  const ImproveResult full = improve(domain, {{.target_amips = 4, .max_passes = 3, .max_growth = 1.5}, {}});
  EXPECT_LT(full.after.tets, 1000U);
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveOptions, LengthAndEnergyAreBothReachedOrMeasured) {
  for (const double target : {4.0, 10.0}) {
    TetDomain domain(make_box({.n = 2, .squash = 0.5}).input);
    const Kept kept(domain);
    const ImproveResult r =
        improve(domain, {{.target_amips = target, .max_passes = 2, .edge_length = 0.25}, {}});
    const std::vector<double> lengths = edge_lengths(domain);
    EXPECT_DOUBLE_EQ(r.lengths.longest, lengths.back());
    EXPECT_DOUBLE_EQ(r.lengths.shortest, lengths.front());
    EXPECT_EQ(r.lengths.too_long, 0U) << target;
    EXPECT_LE(lengths.back(), 0.25 * 4 / 3 * (1 + 1e-12)) << target;
    EXPECT_EQ(kept.fault(domain), "");
  }
}

TEST(ImproveOptions, KeepsRegionsAndTheBoundaryThatAreInNoSurface) {
  Box box = make_box({.sheet = false, .curve = false, .squash = 0.9999});
  box.input.triangles.corners.clear();
  box.input.patches.clear();
  TetDomain domain(box.input, {.boundary = false, .interfaces = false});
  ASSERT_FALSE(domain.surface());
  const Kept kept(domain);
  const ImproveResult r = improve(domain, {{.target_amips = 5, .max_passes = 3}, {}});
  EXPECT_LT(r.after.max_amips, r.before.max_amips);
  EXPECT_EQ(kept.fault(domain), "");
}

// The wedge between two sides of a prism forces a bad tetrahedron, whatever is done.
TEST(ImproveOptions, EndsByItselfNearTheBoundWhereTheTargetIsImpossible) {
  for (const double height : {0.05, 0.01}) {
    TaggedTetrahedra prism;
    prism.points = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {1, 0, height}, {1, 1, height}};
    prism.tets.corners = {0, 1, 3, 5, 0, 3, 2, 5, 0, 2, 4, 5};
    for (std::size_t t = 0; t < prism.tets.corners.size(); t += 4) {
      const auto at = [&](std::size_t i) { return Vec3(prism.points[prism.tets.corners[t + i]].data()); };
      if ((at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) < 0)
        std::swap(prism.tets.corners[t], prism.tets.corners[t + 1]);
    }
    prism.tets.vertices = 6;
    TetDomain domain(prism);
    const Kept kept(domain);
    const ImproveResult r = improve(domain, {{.max_passes = 1000}, {}});
    EXPECT_GT(r.least_max_amips, 10);
    EXPECT_LE(r.after.max_amips, 1.25 * r.least_max_amips) << height;
    EXPECT_LE(r.after.tets, 5500U) << height;
    EXPECT_EQ(kept.fault(domain), "") << height;
  }
}

TEST(ImproveOptions, NoPassesMeansNoChange) {
  TetDomain domain(make_box({.squash = 0.999}).input);
  const TaggedTetrahedra before = domain.tagged();
  const ImproveResult r = improve(domain, {{.max_passes = 0}, {}});
  EXPECT_FALSE(r.target_reached);
  EXPECT_EQ(r.before.max_amips, r.after.max_amips);
  EXPECT_EQ(domain.tagged().points, before.points);
}

TEST(ImproveOptions, ProgressMayAbandonTheRun) {
  TetDomain domain(make_box({.squash = 0.999}).input);
  const Kept kept(domain);
  DomainImproveOptions options;
  int calls = 0;
  options.progress = [&](const ImproveProgress& p) {
    EXPECT_EQ(p.pass, ++calls);
    throw std::runtime_error("stop");
  };
  EXPECT_THROW(improve(domain, options), std::runtime_error);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(kept.fault(domain), "");
}

}  // namespace
}  // namespace multimesh
