// SPDX-License-Identifier: BSD-3-Clause
// Spot, a real textured model: seams, junctions and charts after decimation.
#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/validate.hpp"
#include "test/algorithms/decimate_cost_name.hpp"
#include "test/algorithms/judge.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {
namespace {

class DecimateSpot : public ::testing::TestWithParam<DecimateCost> {
 protected:
  /// Decimates to a share of the faces and expects all that must hold.
  void run(double ratio) {
    TexturedSurface surface(spot());
    DecimateOptions options;
    options.cost = GetParam();
    options.faces = static_cast<std::size_t>(ratio * static_cast<double>(spot().triangles.size()));
    const DecimateResult r = decimate(surface, options);
    EXPECT_EQ(r.stop, DecimateResult::Stop::faces) << r.faces_after << " faces left";
    EXPECT_LE(r.faces_after, options.faces);
    EXPECT_EQ(validate(surface.tree()), std::vector<std::string>());
    std::vector<Index> source;
    const TexturedTriangles after = surface.triangles(source);
    EXPECT_EQ(after.triangles.size(), r.faces_after);
    EXPECT_EQ(facts(after), facts(spot()));
    EXPECT_EQ(newly_flipped(spot(), after, source), 0U);
  }
};

TEST_P(DecimateSpot, KeepsSeamGraphAtFiftyPercent) {
  run(0.5);
}
TEST_P(DecimateSpot, KeepsSeamGraphAtTenPercent) {
  run(0.1);
}
TEST_P(DecimateSpot, KeepsSeamGraphAtTwoPercent) {
  run(0.02);
}

INSTANTIATE_TEST_SUITE_P(Cost, DecimateSpot, ::testing::Values(DecimateCost::quadric, DecimateCost::length),
                         [](const auto& p) { return name_of(p.param); });

// The area below which a triangle of the texture counts as having none must not depend on another chart:
// otherwise one triangle far away in the texture would hide the flips of all others.
TEST(DecimateSpot, AFarChartDoesNotHideFlipsOfTheOthers) {
  TexturedTriangles in = spot();
  const auto v = static_cast<std::int32_t>(in.positions.size());
  const auto vt = static_cast<std::int32_t>(in.texcoords.size());
  for (const Vec2& p : {Vec2(5e5, 0), Vec2(6e5, 0), Vec2(5e5, 1e5)}) {
    in.positions.push_back({3 + 1e-6 * p[0], 1e-6 * p[1], 0});
    in.texcoords.push_back(p);
  }
  in.triangles.push_back({{{v, vt}, {v + 1, vt + 1}, {v + 2, vt + 2}}});
  TexturedSurface surface(in);
  DecimateOptions options;
  options.faces = spot().triangles.size() / 10;
  (void)decimate(surface, options);
  std::vector<Index> source;
  TexturedTriangles after = surface.triangles(source);
  const auto far = std::find(source.begin(), source.end(), spot().triangles.size()) - source.begin();
  after.triangles.erase(after.triangles.begin() + far);
  source.erase(source.begin() + far);
  EXPECT_EQ(newly_flipped(spot(), after, source), 0U);
}

TEST(DecimateSpot, TheJudgeSeesWhatIsKnownOfSpot) {
  const Facts f = facts(spot());
  EXPECT_EQ(f.surface.components, 1);
  EXPECT_EQ(f.surface.euler, 2);
  EXPECT_EQ(f.surface.boundary, 0);
  EXPECT_EQ(f.texture.components, 13);
  EXPECT_EQ(f.seams.junctions, 18);
}

}  // namespace
}  // namespace multimesh::test
