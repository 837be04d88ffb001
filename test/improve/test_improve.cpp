// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/error.hpp"
#include "test/improve/made_domain.hpp"

namespace multimesh {
namespace {

using test::BoxOptions;
using test::Kept;
using test::make_box;

std::size_t done(const ImproveResult& r) {
  std::size_t n = 0;
  for (const OperationCount& c : r.operations) n += c.done;
  return n;
}

TEST(Improve, ReachesTheTargetOnABoxOfSlivers) {
  for (const double squash : {0.5, 0.97, 0.9999, 0.99999999}) {
    BoxOptions options;
    options.squash = squash;
    TetDomain domain(make_box(options).input);
    const Kept kept(domain);
    const double before = test::max_amips(domain);
    const ImproveResult r = improve(domain);
    EXPECT_TRUE(r.target_reached) << squash << ": " << r.after.max_amips;
    EXPECT_DOUBLE_EQ(r.before.max_amips, before);
    EXPECT_DOUBLE_EQ(r.after.max_amips, test::max_amips(domain));
    EXPECT_LE(r.after.max_amips, 10);
    EXPECT_EQ(r.after.above_target, 0);
    EXPECT_TRUE(r.obstacles.empty());
    EXPECT_EQ(kept.fault(domain), "") << squash;
  }
}

TEST(Improve, ReachesATighterTargetFromManySeeds) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    BoxOptions options;
    options.seed = seed;
    options.squash = 0.999;
    TetDomain domain(make_box(options).input);
    const Kept kept(domain);
    DomainImproveOptions improve_options;
    improve_options.target_amips = 7;
    const ImproveResult r = improve(domain, improve_options);
    EXPECT_TRUE(r.target_reached) << seed << ": " << r.after.max_amips;
    EXPECT_EQ(kept.fault(domain), "") << seed;
  }
}

// Nothing forces more than 3 there.
TEST(Improve, ReachesTheTargetInLongAndFlatBoxes) {
  for (const Eigen::Vector3d& sides : {Eigen::Vector3d(20, 1, 0.5), Eigen::Vector3d(30, 1, 1),
                                       Eigen::Vector3d(5, 4, 0.25), Eigen::Vector3d(0.1, 0.1, 3)}) {
    BoxOptions options{.n = 2, .sheet = false, .regions = false, .curve = false, .squash = 0.9};
    options.map = sides.asDiagonal();
    TetDomain domain(make_box(options).input);
    const Kept kept(domain);
    const ImproveResult r = improve(domain);
    EXPECT_TRUE(r.target_reached) << sides.transpose() << ": " << r.after.max_amips;
    EXPECT_EQ(kept.fault(domain), "") << sides.transpose();
  }
}

TEST(Improve, LeavesAGoodMeshAlone) {
  BoxOptions options;
  options.squash = 0;
  TetDomain domain(make_box(options).input);
  const TaggedTetrahedra before = domain.tagged();
  const ImproveResult r = improve(domain);
  EXPECT_TRUE(r.target_reached);
  EXPECT_EQ(done(r), 0);
  EXPECT_EQ(r.passes, 0);
  EXPECT_EQ(domain.tagged().points, before.points);
  EXPECT_EQ(domain.tagged().tets.corners, before.tets.corners);
}

TEST(Improve, NeverMakesTheWorstWorseWhateverTheTarget) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    BoxOptions options;
    options.n = 2;
    options.seed = seed;
    options.squash = 0.999;
    for (const double target : {3.0, 4.0, 5.0}) {
      TetDomain domain(make_box(options).input);
      const Kept kept(domain);
      DomainImproveOptions improve_options;
      improve_options.target_amips = target;
      improve_options.max_passes = 4;
      const ImproveResult r = improve(domain, improve_options);
      EXPECT_LE(r.after.max_amips, r.before.max_amips);
      EXPECT_EQ(r.target_reached, r.obstacles.empty());
      std::size_t explained = 0;
      for (const ImproveObstacle& o : r.obstacles) explained += o.tets;
      EXPECT_EQ(explained, r.after.above_target);
      EXPECT_EQ(kept.fault(domain), "") << seed << ' ' << target;
    }
  }
}

TEST(Improve, DoesTheSameTwice) {
  TaggedTetrahedra results[2];
  for (TaggedTetrahedra& result : results) {
    TetDomain domain(make_box({.squash = 0.9999}).input);
    improve(domain, {{.target_amips = 6}, {}});
    result = domain.tagged();
  }
  EXPECT_EQ(results[0].points, results[1].points);
  EXPECT_EQ(results[0].tets.corners, results[1].tets.corners);
  EXPECT_EQ(results[0].regions, results[1].regions);
  EXPECT_EQ(results[0].triangles.corners, results[1].triangles.corners);
}

TEST(Improve, CountsEveryCandidateOnce) {
  TetDomain domain(make_box({.squash = 0.999}).input);
  const ImproveResult r = improve(domain);
  EXPECT_EQ(r.operations.size(), 5);
  EXPECT_GT(done(r), 0);
  for (const OperationCount& c : r.operations) {
    std::size_t refused = 0;
    for (const auto& [reason, n] : c.refused) refused += n;
    EXPECT_LE(refused + c.done, c.tried) << c.name;  // candidates that others were better than are neither
  }
}

TEST(Improve, RefusesInvertedAndFlatTetrahedraByName) {
  for (const double z : {-0.25, 0.0}) {
    TaggedTetrahedra t;
    t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.25, 0.25, z}};
    // Two on the face (0,1,2), oriented alike: the second is inverted unless its apex is below.
    t.tets.corners = {0, 1, 2, 3, 0, 2, 1, 4};
    t.tets.vertices = 5;
    if (z < 0) t.points[4][2] = 0.25;
    TetDomain domain(t);
    try {
      improve(domain);
      ADD_FAILURE() << "not refused";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("tetrahedron 1"), std::string::npos) << e.what();
    }
    EXPECT_EQ(domain.tagged().points, t.points);
  }
}

TEST(Improve, RefusesBadOptions) {
  TetDomain domain(make_box({.n = 2, .squash = 0.5}).input);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(improve(domain, {{.target_amips = 2.9}, {}}), InputError);
  EXPECT_THROW(improve(domain, {{.target_amips = std::nan("")}, {}}), InputError);
  EXPECT_THROW(improve(domain, {{.max_passes = -1}, {}}), InputError);
  EXPECT_THROW(improve(domain, {{.edge_length = -1}, {}}), InputError);
  EXPECT_THROW(improve(domain, {{.edge_length = infinity}, {}}), InputError);
  EXPECT_THROW(improve(domain, {{.min_edge_length = -1}, {}}), InputError);
  EXPECT_THROW(improve(domain, {{.max_edge_length = -1}, {}}), InputError);
}

}  // namespace
}  // namespace multimesh
