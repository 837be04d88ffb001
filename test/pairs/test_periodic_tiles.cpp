// SPDX-License-Identifier: BSD-3-Clause
// Algorithms for any surface, on a tile and on the surface of the material in one: all copies move together.
#include <gtest/gtest.h>

#include <cmath>

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/betti.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

/// Moves vertices off their places, on the sides and in between, all copies alike.
PeriodicTile shaken(PeriodicTile tile, double by) {
  for (auto& p : tile.points)
    for (std::size_t i = 0; i < 2; ++i) {
      const double other = p[1 - i] - std::floor(p[1 - i]);
      if (p[i] > 0 && p[i] < 1) p[i] += by * std::sin(37 * p[i] + 11 * other * (1 - other));
    }
  return tile;
}

class PeriodicRemesh : public testing::TestWithParam<double> {};

TEST_P(PeriodicRemesh, OfATileKeepsItsBoxAndTopology) {
  for (const double shake : {0.0, 0.04}) {
    PeriodicDomain domain(shaken(square_tile(9, 6), shake), along(true, true, false));
    RemeshOptions options;
    options.length = GetParam();
    const RemeshResult r = remesh(domain.embedding(), domain.tile(), options);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), (std::vector<long>{1, 2, 1}));
    EXPECT_TRUE(copies_fit(domain));
    EXPECT_EQ(inverted(domain), 0U);
    EXPECT_NEAR(size(domain), 1, 1e-12);
    EXPECT_GT(double(r.edges_in_range), 0.8 * double(r.edges));
    for (const PeriodicSide& side : domain.sides()) {  // as straight as they were
      const PeriodicTile now = domain.tile_lists();
      const std::size_t axis = side.shift[0] != 0 ? 0 : 1;
      for (const Index v : side.master.corners) EXPECT_EQ(now.points[v][axis], 0);
      for (const Index v : side.slave.corners) EXPECT_EQ(now.points[v][axis], 1);
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Lengths, PeriodicRemesh, testing::Values(0.04, 0.1, 0.2));

TEST(PeriodicSurface, IsRemeshedWhileAllCopiesOfTheTetrahedraFollow) {
  for (const auto& axes : {along(true, true, false), along(true, false, false)}) {
    PeriodicDomain domain(cube_tile(5), axes);
    const auto surface = domain.add_surface();
    ASSERT_TRUE(surface);
    const auto before = betti(domain.tree().mesh(NodeId::root));
    RemeshOptions options;
    options.length = 0.13;
    const RemeshResult r = remesh(domain.embedding(), *surface, options);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), before);
    EXPECT_TRUE(copies_fit(domain));
    EXPECT_EQ(inverted(domain), 0U);
    EXPECT_NEAR(size(domain), 1, 0.01);                          // the edges of the rod are no curves
    EXPECT_GT(double(r.edges_in_range), 0.4 * double(r.edges));  // nobody improves the tetrahedra
  }
}

}  // namespace
}  // namespace multimesh::test
