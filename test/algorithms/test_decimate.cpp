// SPDX-License-Identifier: BSD-3-Clause
// Decimation of surfaces made by code: topology, orientation, and consistency of position and texture.
#include <gtest/gtest.h>

#include <cmath>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/decimate_cost_name.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

struct Case {
  MadeSurface surface;
  DecimateCost cost;
  double ratio;
};

enum class Which { all, affine };

std::vector<Case> cases(Which which) {
  std::vector<Case> all;
  for (const MadeSurface& s : made_surfaces()) {
    if (which == Which::affine && s.maps.empty()) continue;
    for (const DecimateCost cost : {DecimateCost::quadric, DecimateCost::length})
      for (const double ratio : {0.5, 0.1, 0.02}) all.push_back({s, cost, ratio});
  }
  return all;
}

std::string name_of(const Case& c) {
  return c.surface.name + name_of(c.cost) + std::to_string(std::lround(100 * c.ratio));
}

void PrintTo(const Case& c, std::ostream* out) {
  *out << name_of(c);
}

const auto name_of_info = [](const auto& info) { return name_of(info.param); };

bool same_topology(const MeshReport& x, const MeshReport& y) {
  return x.components == y.components && x.euler_characteristic == y.euler_characteristic &&
         x.boundary == y.boundary && x.genus == y.genus;
}

class Decimate : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    std::vector<Index> all;
    before = surface.triangles(all);
    goal = static_cast<std::size_t>(GetParam().ratio * static_cast<double>(before.triangles.size()));
    for (const NodeId n : surface.tree().nodes()) reports.push_back(report(surface.tree().mesh(n)));
    seams = report_seams(surface);
    DecimateOptions options;
    options.cost = GetParam().cost;
    options.faces = goal;
    result = decimate(surface, options);
    after = surface.triangles(source);
  }

  const MadeSurface& made() const { return GetParam().surface; }

  TexturedSurface surface{GetParam().surface.input};
  TexturedTriangles before, after;
  std::vector<MeshReport> reports;
  SeamReport seams;
  std::vector<Index> source;
  std::size_t goal = 0;
  DecimateResult result;
};

TEST_P(Decimate, KeepsTopologyOfSurfaceChartsAndSeams) {
  EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
  EXPECT_EQ(facts(after), facts(before));
  for (std::size_t i = 0; i < reports.size(); ++i)
    EXPECT_TRUE(same_topology(report(surface.tree().mesh(surface.tree().nodes()[i])), reports[i]))
        << "mesh " << i;
  const SeamReport now = report_seams(surface);
  EXPECT_EQ(now.curves, seams.curves);
  EXPECT_EQ(now.ends, seams.ends);
  EXPECT_EQ(now.junctions, seams.junctions);
}

TEST_P(Decimate, FlipsNothingInTheTexture) {
  EXPECT_EQ(newly_flipped(made().input, after, source), 0U);
}

class DecimateAffine : public Decimate {};

TEST_P(DecimateAffine, PositionAndTextureDenoteTheSamePoint) {
  double error = 0;
  for (std::size_t t = 0; t < after.triangles.size(); ++t)
    for (const auto& c : after.triangles[t]) {
      const std::size_t chart = made().chart[source[t]];
      ASSERT_EQ(chart == no_texture, c.texcoord < 0);
      if (chart == no_texture) continue;
      const auto expected = made().maps[chart](after.positions[static_cast<std::size_t>(c.position)]);
      error = std::max(error, (after.texcoords[static_cast<std::size_t>(c.texcoord)] - expected).norm());
    }
  // Exact except for corners that are cut off: there position and texture coordinates compromise differently.
  EXPECT_LT(error, GetParam().ratio < 0.1 ? 1e-2 : 1e-6);
}

TEST_P(Decimate, CountsAddUp) {
  EXPECT_EQ(result.faces_before, before.triangles.size());
  EXPECT_EQ(result.faces_after, after.triangles.size());
  EXPECT_EQ(result.faces_after, surface.live_triangles());
  EXPECT_LE(result.collapsed, result.faces_before - result.faces_after);
  EXPECT_GE(2 * result.collapsed, result.faces_before - result.faces_after);
  EXPECT_GE(result.tried, result.collapsed);
  EXPECT_TRUE(std::isfinite(result.max_cost) && result.max_cost >= 0);
}

TEST_P(Decimate, ReachesTheTargetOrSaysWhatBlocksIt) {
  if (result.stop == DecimateResult::Stop::faces) {
    EXPECT_LE(result.faces_after, goal);
    EXPECT_GE(result.faces_after + 1, goal) << "no collapse removes more than two faces";
    EXPECT_TRUE(result.blocking.empty());
    return;
  }
  EXPECT_EQ(result.stop, DecimateResult::Stop::exhausted);
  EXPECT_GT(result.faces_after, goal);
  std::size_t edges = 0;
  for (const auto& [reason, count] : result.blocking) {
    EXPECT_FALSE(reason.empty());
    edges += count;
  }
  EXPECT_EQ(edges, report(surface.tree().mesh(NodeId::root)).edges) << "every edge that is left has a reason";
}

TEST_P(Decimate, ReachesTenPercentOfWhatHasRoomForIt) {
  if (GetParam().ratio < 0.1) return;  // these surfaces are too small
  EXPECT_EQ(result.stop, DecimateResult::Stop::faces) << result.faces_after << " left, " << goal << " wanted";
}

TEST_P(Decimate, TwoRunsAreEqual) {
  TexturedSurface again(made().input);
  DecimateOptions options;
  options.cost = GetParam().cost;
  options.faces = goal;
  const DecimateResult other = decimate(again, options);
  EXPECT_EQ(other.tried, result.tried);
  EXPECT_EQ(other.max_cost, result.max_cost);
  std::vector<Index> other_source;
  const TexturedTriangles other_after = again.triangles(other_source);
  EXPECT_EQ(other_source, source);
  EXPECT_EQ(other_after.positions, after.positions);
  EXPECT_EQ(other_after.texcoords, after.texcoords);
}

INSTANTIATE_TEST_SUITE_P(Made, Decimate, ::testing::ValuesIn(cases(Which::all)), name_of_info);
INSTANTIATE_TEST_SUITE_P(Made, DecimateAffine, ::testing::ValuesIn(cases(Which::affine)), name_of_info);

}  // namespace
}  // namespace multimesh::test
