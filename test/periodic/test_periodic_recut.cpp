// SPDX-License-Identifier: BSD-3-Clause
// A tile is cut elsewhere: another cell of the same pattern.
#include <gtest/gtest.h>

#include <map>

#include "multimesh/domains/periodic_domain/recut.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/betti.hpp"
#include "test/periodic/periodic_storm.hpp"
#include "test/periodic/recut.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

class CutElsewhere : public testing::TestWithParam<std::tuple<int, Recut>> {};

TEST_P(CutElsewhere, IsTheSamePatternBeforeAndAfterOperations) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto [d, how] = GetParam();
    RecutTorus torus = recut_torus(d, 4, how, random);
    for (std::size_t f = 0; f < torus.tile.facets.size(); ++f)
      torus.tile.regions.push_back(random() % 4 ? 8 : 3);
    torus.options.interfaces = true;
    PeriodicDomain domain(torus.tile, torus.options);
    const auto before = sizes(domain);
    const auto expect_same = [&](const PeriodicDomain& now) {
      EXPECT_EQ(validate(now.tree()), std::vector<std::string>{});
      EXPECT_EQ(now.report().euler, 0);
      EXPECT_EQ(betti(now.tree().mesh(NodeId::root)), betti(domain.tree().mesh(NodeId::root)));
      EXPECT_EQ(inverted(now), 0U);
      EXPECT_LE(now.mismatch(), 1e-15);
      const auto after = sizes(now);
      ASSERT_EQ(after.size(), before.size());
      for (const auto& [region, size] : before) EXPECT_NEAR(after.at(region), size, 1e-12) << region;
    };
    RecutTile other(domain, {0.5, 0.4, 0.3}, true);
    EXPECT_EQ(other.domain().report().simplices, domain.report().simplices);
    expect_same(other.domain());
    const PeriodicDomain untouched = other.back();
    EXPECT_EQ(untouched.report().simplices, domain.report().simplices);
    expect_same(untouched);
    PeriodicStorm storm(other.domain(), seed, true);
    for (int i = 0; i < 300; ++i) storm.step();
    const auto stormy = sizes(other.domain());
    const PeriodicDomain back = other.back();
    EXPECT_EQ(validate(back.tree()), std::vector<std::string>{});
    for (const auto& [region, size] : sizes(back)) EXPECT_NEAR(stormy.at(region), size, 1e-12) << region;
  }
}
INSTANTIATE_TEST_SUITE_P(Tori, CutElsewhere,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(Recut::rows, Recut::blocks, Recut::plane)));

TEST(CutElsewhereLists, CarriesWhatIsListedAndDropsWhatLiesInTheSides) {
  PeriodicTile tile = square_tile(6, 6);
  const auto vertex = [](Index i, Index j) { return i * 7 + j; };
  auto& lines = tile.listed[1];
  for (Index j = 0; j < 6; ++j) {
    for (const Index i : {0U, 3U}) {
      lines.simplices.corners.push_back(vertex(i, j));
      lines.simplices.corners.push_back(vertex(i, j + 1));
      lines.tags.push_back(i == 0 ? 1 : 2);
    }
  }
  tile.listed[0].simplices.corners.push_back(vertex(1, 2));
  tile.listed[0].tags.push_back(7);
  const PeriodicDomain domain(tile, along(true, true, false));
  RecutTile other(domain, {0.5, 0.5, 0}, true);
  EXPECT_EQ(other.dropped(), 6U);
  const PeriodicTile back = other.back().tile_lists();
  EXPECT_EQ(back.listed[0].tags, std::vector<PeriodicTile::Region>{7});
  EXPECT_EQ(back.listed[1].tags, std::vector<PeriodicTile::Region>(6, 2));
  for (const Index v : back.listed[1].simplices.corners) EXPECT_DOUBLE_EQ(back.points[v][0], 0.5);
}

}  // namespace
}  // namespace multimesh::test
