// SPDX-License-Identifier: BSD-3-Clause
// Sides whose partners are sums and differences of periods away.
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "adapters/io/gunzip.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/betti.hpp"
#include "test/periodic/periodic_storm.hpp"
#include "test/periodic/recut.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

using Numbers = std::array<std::size_t, 4>;

void expect_torus(const PeriodicTile& tile, const PeriodicOptions& options, const Numbers& simplices) {
  PeriodicDomain domain(tile, options);
  EXPECT_EQ(domain.report().simplices, simplices);
  EXPECT_EQ(domain.report().euler, 0);
  EXPECT_EQ(domain.report().cut_root_vertices, 0U);
  EXPECT_EQ(domain.report().inverted_facets, 0U);
  EXPECT_LE(domain.mismatch(), 1e-15);
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)),
            tile.facets.dimension == 2 ? (std::vector<long>{1, 2, 1}) : (std::vector<long>{1, 3, 3, 1}));
  EXPECT_FALSE(domain.add_surface());  // no side was left open
}

/// A hexagon of 6 m^2 triangles: a + b, 2a - b and their difference lead from side to opposite side.
PeriodicTile hexagon(int m) {
  PeriodicTile tile{{}, {2, 0, {}}};
  std::map<std::pair<int, int>, Index> vertex;
  const auto at = [&](int i, int j) {
    const auto [entry, is_new] = vertex.try_emplace({i, j}, static_cast<Index>(tile.points.size()));
    if (is_new) tile.points.push_back({i + 0.5 * j, std::sqrt(0.75) * j, 0});
    return entry->second;
  };
  const auto inside = [m](int i, int j) {
    return std::max({std::abs(i), std::abs(j), std::abs(i + j)}) <= m;
  };
  const auto add = [&](std::array<std::array<int, 2>, 3> t) {
    for (const auto& [i, j] : t)
      if (!inside(i, j)) return;
    for (const auto& [i, j] : t) tile.facets.corners.push_back(at(i, j));
  };
  for (int i = -m; i <= m; ++i)
    for (int j = -m; j <= m; ++j) {
      add({{{i, j}, {i + 1, j}, {i, j + 1}}});
      add({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
    }
  tile.facets.vertices = static_cast<Index>(tile.points.size());
  return tile;
}

std::array<double, 3> hexagon_step(int i, int j) {
  return {i + 0.5 * j, std::sqrt(0.75) * j, 0};
}

TEST(PeriodicLattice, MatchesAllThreePairsOfSidesOfAHexagon) {
  for (const int m : {2, 3, 5}) {
    const std::array<std::array<double, 3>, 3> steps{hexagon_step(m, m), hexagon_step(2 * m, -m),
                                                     hexagon_step(-m, 2 * m)};
    const auto n = static_cast<std::size_t>(3 * m * m);
    for (const auto& [a, b] : {std::pair{0, 1}, {1, 2}, {2, 0}}) {
      PeriodicOptions options = along(true, true, false);
      options.periods = {{steps[static_cast<std::size_t>(a)], steps[static_cast<std::size_t>(b)], {}}};
      expect_torus(hexagon(m), options, {n, 3 * n, 2 * n, 0});
    }
  }
}

TEST(PeriodicLattice, MatchesBricksWhoseTopIsTheirBottomShiftedByHalf) {
  PeriodicOptions flat = along(true, true, false);
  flat.periods = {{{1, 0, 0}, {0.5, 1, 0}, {}}};
  expect_torus(square_tile(6, 5), flat, {30, 90, 60, 0});
  for (const double shift : {0.5, -0.5, 1.0 / 3, 1.5}) {
    PeriodicOptions solid = along(true, true, true);
    solid.periods = {{{1, 0, 0}, {shift, 1, 0}, {0, 0, 1}}};
    expect_torus(cube_tile(6), solid, {216, 1512, 2592, 1296});
    solid.periods = {{{1, 0, 0}, {shift, 1, 0}, {0.5, -shift, 1}}};
    expect_torus(cube_tile(6), solid, {216, 1512, 2592, 1296});
  }
}

class PeriodicRecut : public testing::TestWithParam<std::tuple<int, Recut>> {};

TEST_P(PeriodicRecut, IsTheTorusThatItWasCutFrom) {
  const auto [d, how] = GetParam();
  for (unsigned seed = 0; seed < (d == 2 ? 40U : 10U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const RecutTorus torus = recut_torus(d, d == 2 ? 6 : 4, how, random);
    expect_torus(torus.tile, torus.options, torus.simplices);
  }
}

TEST_P(PeriodicRecut, StaysPeriodicInAStorm) {
  const auto [d, how] = GetParam();
  std::mt19937 random(77);
  const RecutTorus torus = recut_torus(d, 6, how, random);
  PeriodicDomain domain(torus.tile, torus.options);
  PeriodicStorm storm(domain, 5, true);
  for (int i = 0; i < 3000; ++i) storm.step();
  EXPECT_EQ(storm.fault(), "");
  EXPECT_GT(storm.done, 300U);
}

TEST_P(PeriodicRecut, IsRefusedIfASideIsOff) {
  const auto [d, how] = GetParam();
  std::size_t on_sides = 0;
  for (unsigned seed = 0; seed < (d == 2 ? 40U : 10U); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    RecutTorus torus = recut_torus(d, d == 2 ? 6 : 4, how, random);
    PeriodicDomain domain(torus.tile, torus.options);
    for (int k = 0; k < 10; ++k) {
      // A vertex with copies, and so in a side; of those in one side only, so that its faces lie in that.
      const Mesh& mesh = domain.tree().mesh(domain.tile());
      const auto v = static_cast<Index>(random() % mesh.capacity(0));
      DartBuffer copies;
      const Dart at = mesh.dart_of(0, v);
      domain.tree().to_child(domain.tile(), domain.tree().to_parent(domain.tile(), at), 0, copies);
      if (copies.size() != 2) continue;
      ++on_sides;
      PeriodicTile off = torus.tile;
      auto& place = off.points[domain.input_vertices()[v]];
      place[0] += 0.004, place[1] -= 0.003;
      EXPECT_NE(refusal(off, torus.options).find("do not match"), std::string::npos)
          << refusal(off, torus.options);
    }
  }
  EXPECT_GT(on_sides, 10U);
}

INSTANTIATE_TEST_SUITE_P(All, PeriodicRecut,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(Recut::rows, Recut::blocks, Recut::plane)));

TEST(PeriodicLattice, SidesMeshedDifferentlyAreRefused) {
  // A cube upon its mirror image: the vertices of top and bottom have partners, but the diagonals differ.
  const PeriodicTile cube = cube_tile(3);
  PeriodicTile tile{{}, {3, 0, {}}};
  std::map<std::array<double, 3>, Index> vertex;
  for (const bool mirrored : {false, true})
    for (const Index v : cube.facets.corners) {
      auto p = cube.points[v];
      if (mirrored) p = {std::round(3 * (1 - p[0])) / 3, p[1], 1 + p[2]};
      const auto [entry, is_new] = vertex.try_emplace(p, static_cast<Index>(tile.points.size()));
      if (is_new) tile.points.push_back(p);
      tile.facets.corners.push_back(entry->second);
    }
  const std::string why = refusal(tile, along(true, true, true));
  EXPECT_NE(why.find("do not match facet by facet"), std::string::npos) << why;
  EXPECT_NE(why.find("along z"), std::string::npos) << why;
}

/// A tile of the data folder: numbers of points and tetrahedra, then those.
PeriodicTile data_tile(const std::string& name) {
  const io::UnpackedBytes bytes(std::filesystem::path(MULTIMESH_TEST_SOURCE_DIR) / "data" / name);
  std::istringstream in{std::string(bytes.view())};
  std::size_t points = 0, facets = 0;
  PeriodicTile tile;
  in >> points >> facets >> tile.facets.dimension;
  tile.points.resize(points);
  for (auto& p : tile.points) in >> p[0] >> p[1] >> p[2];
  tile.facets.corners.resize(facets * tile.facets.corners_per_facet());
  for (Index& v : tile.facets.corners) in >> v;
  tile.facets.vertices = static_cast<Index>(points);
  EXPECT_TRUE(in);
  return tile;
}

TEST(PeriodicLattice, GluesTilesThatOthersHaveCut) {
  PeriodicOptions brick = along(true, true, true), box = brick;
  brick.periods = {{{1, 0, 0}, {0.5, 1, 0}, {0, 0, 1}}};
  box.periods = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  expect_torus(data_tile("p_brick.txt.gz"), brick, {216, 1512, 2592, 1296});
  expect_torus(data_tile("p_jag.txt.gz"), box, {216, 1512, 2592, 1296});
}

TEST(PeriodicLattice, NoTetrahedronIsFlatOrInvertedAfterAStorm) {
  PeriodicOptions shear = along(true, true, true);
  shear.periods = {{{1, 0.3, 0.2}, {0, 1, 0.1}, {0, 0, 1}}};
  for (const unsigned seed : {1U, 2U, 3U}) {
    PeriodicDomain domain(data_tile("p_shear.txt.gz"), shear);
    PeriodicStorm storm(domain, seed, true);
    while (storm.done < 10000 && storm.refused < 1000000) storm.step();
    EXPECT_EQ(storm.fault(), "") << "seed " << seed;  // of each, by integers of any size
    EXPECT_GE(storm.done, 10000U);
  }
}

TEST(PeriodicLattice, ATileOfManyPeriodsIsRefused) {
  PeriodicOptions options = along(true, true, false);
  options.periods = {{{0.001, 0, 0}, {0, 1, 0}, {}}};
  EXPECT_NE(refusal(square_tile(4, 4), options).find("times as long as its period along x"),
            std::string::npos);
}

}  // namespace
}  // namespace multimesh::test
