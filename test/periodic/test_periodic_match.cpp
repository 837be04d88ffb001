// SPDX-License-Identifier: BSD-3-Clause
// Which vertices are identified, and the messages where they cannot be.
#include <gtest/gtest.h>

#include <random>

#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

const PeriodicOptions xy = along(true, true, false);

TEST(PeriodicMatch, NamesTheVertexWithoutPartner) {
  PeriodicTile tile = square_tile(4, 4);
  tile.points[22][1] += 0.01;  // (1, 0.5)
  const std::string why = refusal(tile, xy);
  EXPECT_NE(why.find("along x do not match: vertex 2 at (0, 0.5, 0) has no partner at (1, 0.5, 0)"),
            std::string::npos)
      << why;
  EXPECT_NE(why.find("the nearest is vertex 22, at distance 0.01"), std::string::npos) << why;
}

TEST(PeriodicMatch, NamesTheVertexOfTheHighSideThatTheLowSideLacks) {
  PeriodicTile tile = square_tile(4, 4);
  tile.points[2][0] -= 1e-4;  // the low side is now this vertex alone
  const std::string why = refusal(tile, xy);
  EXPECT_NE(why.find("do not match"), std::string::npos) << why;
  tile = square_tile(4, 4);
  tile.points[2][0] += 0.05;  // it left the low side
  const std::string high = refusal(tile, xy);
  EXPECT_NE(high.find("vertex 22 at (1, 0.5, 0) has no partner at (0, 0.5, 0)"), std::string::npos) << high;
}

TEST(PeriodicMatch, RefusesTwoPartners) {
  PeriodicTile tile = square_tile(4, 4);
  PeriodicOptions wide = xy;
  wide.tolerance = 0.02;
  tile.points[17][0] = 0.98;  // was (0.75, 0.5), is now within the tolerance of (1, 0.5)
  const std::string why = refusal(tile, wide);
  EXPECT_NE(why.find("has two partners"), std::string::npos) << why;
}

TEST(PeriodicMatch, ToleratesNoiseAndRemovesIt) {
  std::mt19937 random(7);
  PeriodicTile tile = cube_tile(4);
  for (auto& p : tile.points)
    for (double& x : p) x += 1e-7 * (double(random() % 2001) / 1000 - 1);
  PeriodicDomain domain(tile, along(true, true, true));
  EXPECT_LE(domain.mismatch(), 1e-15);
  EXPECT_GT(domain.report().largest_shift, 1e-8);
  EXPECT_LT(domain.report().largest_shift, 1e-6);
  PeriodicOptions strict = along(true, true, true);
  strict.tolerance = 1e-9;
  EXPECT_NE(refusal(tile, strict), "");
}

/// Most points of the sides are exact, as generators write them; some are off by their rounding.
TEST(PeriodicMatch, NoiseInTheSidesOfABoxLeavesNoTrace) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    const PeriodicTile exact = cube_tile(4);
    PeriodicTile noisy = exact;
    for (auto& p : noisy.points)
      for (double& x : p)
        if (random() % 5 == 0) x += (static_cast<double>(random() % 200) - 100) * 1e-15;
    const PeriodicDomain domain(noisy, along(true, true, true));
    const auto points = domain.tile_lists().points;
    EXPECT_EQ(domain.lattice().periods(), Eigen::Matrix3d(Eigen::Matrix3d::Identity()));
    for (std::size_t v = 0; v < points.size(); ++v)
      for (std::size_t i = 0; i < 3; ++i)
        if (const double x = exact.points[v][i]; x == 0 || x == 1) {
          EXPECT_EQ(points[v][i], x);
        }
    for (const PeriodicCopy& c : domain.copies())
      for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(points[c.slave][i], points[c.master][i] + c.shift[i]);
    const PeriodicDomain again(domain.tile_lists(), domain.gluing());
    EXPECT_EQ(again.tile_lists().points, points);
  }
}

TEST(PeriodicMatch, TakesGivenPairs) {
  const PeriodicTile tile = square_tile(4, 4);
  PeriodicOptions given = xy;
  for (Index i = 0; i <= 4; ++i) {
    given.pairs.push_back({20 + i, i});
    given.pairs.push_back({5 * i, 5 * i + 4});
  }
  PeriodicDomain domain(tile, given);
  EXPECT_EQ(domain.report().with_copies, (std::vector<std::size_t>{0, 9, 6, 0, 1}));

  given.pairs.push_back({0, 7});
  EXPECT_NE(refusal(tile, given).find("pair 0-7"), std::string::npos) << refusal(tile, given);
  given.pairs.back() = {0, 99};
  EXPECT_NE(refusal(tile, given).find("pair 0-99"), std::string::npos);
  // All but one pair: the sides do not match facet by facet, and it stays a slit.
  given.pairs.assign({{20, 0}, {21, 1}, {23, 3}, {24, 4}});
  given.axes = {true, false, false};
  PeriodicDomain slit(tile, given);
  EXPECT_EQ(slit.report().with_copies, (std::vector<std::size_t>{0, 17, 4}));
}

TEST(PeriodicMatch, TakesPeriodsThatAreNotParallelToTheAxes) {
  PeriodicTile tile = square_tile(4, 5);
  for (auto& p : tile.points) p[0] += 0.3 * p[1];
  PeriodicOptions sheared = xy;
  EXPECT_NE(refusal(tile, sheared), "");
  sheared.periods = {{{1, 0, 0}, {0.3, 1, 0}, {0, 0, 0}}};
  PeriodicDomain domain(tile, sheared);
  EXPECT_EQ(domain.report().euler, 0);
  EXPECT_EQ(domain.report().with_copies[4], 1U);
}

TEST(PeriodicMatch, MatchesJaggedSidesWhereTheyMatch) {
  PeriodicTile tile = square_tile(4, 4);
  for (Index j = 0; j <= 4; ++j)  // both sides along x bulge alike
    for (const Index i : {0U, 4U}) tile.points[i * 5 + j][0] += 0.1 * (j % 2);
  PeriodicOptions given = xy;
  given.periods = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  PeriodicDomain domain(tile, given);
  EXPECT_EQ(domain.report().euler, 0);
  EXPECT_EQ(domain.report().with_copies, (std::vector<std::size_t>{0, 9, 6, 0, 1}));
}

TEST(PeriodicMatch, DropsAnAxisWithoutExtent) {
  const PeriodicDomain domain(square_tile(4, 4), along(true, true, true));
  EXPECT_EQ(domain.report().dropped_axes, (std::array<bool, 3>{false, false, true}));
  EXPECT_FALSE(domain.lattice().is_periodic(2));
  EXPECT_EQ(domain.report().euler, 0);
  PeriodicOptions given = along(true, true, true);
  given.periods = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  EXPECT_NE(refusal(square_tile(4, 4), given).find("period along z is 0"), std::string::npos);
}

TEST(PeriodicMatch, RefusesBadInputNamingIt) {
  const PeriodicTile good = square_tile(4, 4);
  EXPECT_NE(refusal(good, along(false, false, true)).find("no extent along z"), std::string::npos);
  EXPECT_NE(refusal(good, along(false, false, false)).find("no periodic axis"), std::string::npos);
  PeriodicTile tile = good;
  tile.facets.corners[7] = 99;
  EXPECT_NE(refusal(tile, xy).find("facet 2 of the tile names vertex 99"), std::string::npos);
  tile = good;
  tile.facets.corners[7] = tile.facets.corners[6];
  EXPECT_NE(refusal(tile, xy).find("facet 2 of the tile has vertex"), std::string::npos);
  tile = good;
  tile.points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal(tile, xy).find("vertex 3 are not finite"), std::string::npos);
  tile = good;
  tile.facets.corners.pop_back();
  EXPECT_NE(refusal(tile, xy).find("corners"), std::string::npos);
  tile = good;
  for (std::size_t i = 0; i < 3; ++i) tile.facets.corners.push_back(tile.facets.corners[i]);
  EXPECT_NE(refusal(tile, xy).find("facets 0 and 32 of the tile lie at the same place"), std::string::npos);
  PeriodicOptions o = xy;
  o.periods = {{{2, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  EXPECT_NE(refusal(good, o).find("shorter than its period along x"), std::string::npos);
  o.periods = {{{1, 0, 0}, {2, 0, 0}, {0, 0, 0}}};
  EXPECT_NE(refusal(good, o).find("linearly independent"), std::string::npos);
  o.periods = {{{0.37, 0, 0}, {0, 1, 0}, {0, 0, 0}}};
  EXPECT_NE(refusal(good, o).find("no two vertices"), std::string::npos);
}

}  // namespace
}  // namespace multimesh::test
