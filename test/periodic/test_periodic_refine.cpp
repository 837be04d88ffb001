// SPDX-License-Identifier: BSD-3-Clause
// Tiles too coarse for a simplicial complex, split until they are one.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "multimesh/domains/periodic_domain/quotient_edges.hpp"
#include "multimesh/domains/periodic_domain/refine_tile.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/betti.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

struct Coarse {
  const char* name;
  PeriodicTile tile;
  PeriodicOptions options;
  std::vector<long> betti;
  friend void PrintTo(const Coarse& c, std::ostream* out) { *out << c.name; }
};

class PeriodicRefinement : public testing::TestWithParam<Coarse> {};

TEST_P(PeriodicRefinement, MakesItProper) {
  const Coarse& c = GetParam();
  PeriodicOptions options = c.options;
  ASSERT_NE(refusal(c.tile, options), "");
  options.refine = true;
  PeriodicDomain domain(c.tile, options);
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});  // no two simplices with the same vertices
  EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), c.betti);
  EXPECT_LE(domain.mismatch(), 1e-15);
  EXPECT_EQ(domain.report().inverted_facets, 0U);
  EXPECT_GT(domain.report().split_edges, 0U);

  // Much less than two barycentric subdivisions, which always suffice.
  const std::size_t now = c.tile.facets.size() + domain.report().added_facets;
  const std::size_t barycentric = c.tile.facets.size() * (c.tile.facets.dimension == 2 ? 36 : 576);
  RecordProperty("facets", static_cast<int>(now));
  std::cout << c.name << ": " << c.tile.facets.size() << " -> " << now << " facets, "
            << domain.report().split_edges << " edges of the root split\n";
  EXPECT_LE(3 * now, barycentric);
  // The parts of a facet are all of it.
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  ASSERT_EQ(domain.input_facets().size(), now);
  double size = 0;
  for (Index f = 0; f < now; ++f) size += signed_measure(domain, f, mean_normal(domain));
  EXPECT_NEAR(size, 1, 1e-12);
  const std::set<Index> inputs(domain.input_facets().begin(), domain.input_facets().end());
  EXPECT_EQ(inputs.size(), c.tile.facets.size());
  EXPECT_GE(mesh.capacity(0), c.tile.points.size());
}

INSTANTIATE_TEST_SUITE_P(
    All, PeriodicRefinement,
    testing::Values(Coarse{"square1x1", square_tile(1, 1), along(true, true, false), {1, 2, 1}},
                    Coarse{"square2x2", square_tile(2, 2), along(true, true, false), {1, 2, 1}},
                    Coarse{"square1x5", square_tile(1, 5), along(true, true, false), {1, 2, 1}},
                    Coarse{"cylinder1x3", square_tile(1, 3), along(true, false, false), {1, 1, 0}},
                    Coarse{"cube1", cube_tile(1), along(true, true, true), {1, 3, 3, 1}},
                    Coarse{"cube2", cube_tile(2), along(true, true, true), {1, 3, 3, 1}},
                    Coarse{"slab1", cube_tile(1), along(true, true, false), {1, 2, 1, 0}},
                    Coarse{"rod2", cube_tile(2), along(false, true, false), {1, 1, 0, 0}}),
    [](const auto& i) { return std::string(i.param.name); });

TEST(PeriodicRefinement, EndsOnLongThinAndShearedTiles) {
  std::mt19937 random(3);
  for (int i = 0; i < 60; ++i) {
    PeriodicTile tile = i % 2 ? cube_tile(1 + i % 3) : square_tile(1 + i % 3, 1 + i % 4);
    PeriodicOptions options = along(true, true, i % 2, true);
    options.periods.emplace();
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    for (int r = 0; r < 3; ++r)
      for (int c = r; c < 3; ++c)
        m(r, c) = r == c ? std::exp2(-double(random() % 7)) : double(random() % 5) / 2;
    for (auto& p : tile.points) Eigen::Map<Eigen::Vector3d>(p.data()) = m * Eigen::Vector3d(p.data());
    for (int c = 0; c < 3; ++c)
      for (int r = 0; r < 3; ++r)
        (*options.periods)[static_cast<std::size_t>(c)][static_cast<std::size_t>(r)] = m(r, c);
    PeriodicDomain domain(tile, options);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    EXPECT_EQ(domain.report().euler, 0) << i;
    EXPECT_LT(domain.report().added_facets, i % 2 ? 2000U : 400U) << i;
  }
}

// The part of the method whose end is certain, without the part that is tried first.
TEST(PeriodicRefinement, EndsByLongestEdgesAlone) {
  for (const int d : {2, 3}) {
    const PeriodicTile in = d == 2 ? square_tile(1, 1) : cube_tile(1);
    LabelledTile tile;
    tile.facets = in.facets;
    tile.input_facet.resize(in.facets.size());
    for (const auto& p : in.points) tile.point.emplace_back(p);
    for (const auto& p : tile.point)
      tile.offset.push_back({static_cast<int>(p[0]), static_cast<int>(p[1]), static_cast<int>(p[2])});
    tile.vertex_class.assign(in.points.size(), 0);
    tile.classes = 1;
    EXPECT_TRUE(too_short(tile));
    refine_tile(tile, 0);
    EXPECT_FALSE(too_short(tile));
    EXPECT_FALSE(double_facet(tile));
    EXPECT_LT(tile.facets.size(), d == 2 ? 72U : 3456U);
    std::cout << "by longest edges: " << in.facets.size() << " -> " << tile.facets.size() << " facets\n";
  }
}

TEST(PeriodicRefinement, LeavesAProperTileAlone) {
  PeriodicDomain domain(square_tile(3, 3), along(true, true, false, true));
  EXPECT_EQ(domain.report().split_edges, 0U);
  EXPECT_EQ(domain.report().simplices[2], 18U);
}

}  // namespace
}  // namespace multimesh::test
