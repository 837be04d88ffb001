// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "multimesh/algorithms/improve.hpp"
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
  const ImproveResult r = improve(domain, {.edge_length = 0.2});
  EXPECT_TRUE(r.target_reached) << r.after.max_amips;
  const std::vector<double> lengths = edge_lengths(domain);
  EXPECT_LE(lengths[lengths.size() * 9 / 10], 0.2 * 4 / 3 + 1e-12);
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveOptions, CoarsensToAnEdgeLength) {
  TetDomain domain(make_box({.n = 8, .sheet = false, .regions = false, .curve = false, .squash = 0.5}).input);
  const Kept kept(domain);
  const ImproveResult r = improve(domain, {.edge_length = 0.4});
  EXPECT_TRUE(r.target_reached) << r.after.max_amips;
  EXPECT_LT(r.after.tets, r.before.tets / 3);
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveOptions, DoesNotSplitBelowTheLeastLength) {
  TetDomain domain(make_box({.squash = 0.9999}).input);
  ImproveOptions options;
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
  ImproveOptions options;
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

TEST(ImproveOptions, KeepsRegionsAndTheBoundaryThatAreInNoSurface) {
  Box box = make_box({.sheet = false, .curve = false, .squash = 0.9999});
  box.input.triangles.corners.clear();
  box.input.patches.clear();
  TetDomain domain(box.input, {.boundary = false, .interfaces = false});
  ASSERT_FALSE(domain.surface());
  const Kept kept(domain);
  const ImproveResult r = improve(domain, {.target_amips = 5, .max_passes = 3});
  EXPECT_LT(r.after.max_amips, r.before.max_amips);
  EXPECT_EQ(kept.fault(domain), "");
}

TEST(ImproveOptions, NoPassesMeansNoChange) {
  TetDomain domain(make_box({.squash = 0.999}).input);
  const TaggedTetrahedra before = domain.tagged();
  const ImproveResult r = improve(domain, {.max_passes = 0});
  EXPECT_FALSE(r.target_reached);
  EXPECT_EQ(r.before.max_amips, r.after.max_amips);
  EXPECT_EQ(domain.tagged().points, before.points);
}

TEST(ImproveOptions, ProgressMayAbandonTheRun) {
  TetDomain domain(make_box({.squash = 0.999}).input);
  const Kept kept(domain);
  ImproveOptions options;
  int calls = 0;
  options.progress = [&](int pass, std::size_t) {
    EXPECT_EQ(pass, ++calls);
    throw std::runtime_error("stop");
  };
  EXPECT_THROW(improve(domain, options), std::runtime_error);
  EXPECT_EQ(calls, 1);
  EXPECT_EQ(kept.fault(domain), "");
}

}  // namespace
}  // namespace multimesh
