// SPDX-License-Identifier: BSD-3-Clause
// Algorithms for any surface, on a tile and on the surface of the material in one: all copies move together.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/algorithms/remesh_tile.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/validate.hpp"
#include "test/improve/surface_distance.hpp"
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

/// A wave along each axis, such that opposite sides are at the same height.
PeriodicTile waved(PeriodicTile tile) {
  const auto wave = [](double x) { return std::sin(2 * std::numbers::pi * (x - std::floor(x))); };
  for (auto& p : tile.points) p[2] = 0.1 * wave(p[0]) * wave(p[1]);
  return tile;
}

/// Its triangles, and the copies of them around it.
std::vector<PlainTriangle> triangles(const PeriodicTile& tile, std::initializer_list<double> shifts) {
  std::vector<PlainTriangle> all;
  for (std::size_t f = 0; f < tile.facets.size(); ++f)
    for (const double x : shifts)
      for (const double y : shifts) {
        PlainTriangle t;
        for (std::size_t i = 0; i < 3; ++i) {
          t[i] = tile.points[tile.facets.facet(f)[i]];
          t[i][0] += x, t[i][1] += y;
        }
        all.push_back(t);
      }
  return all;
}

// Across the sides, too: each vertex is near the other tile or a copy of it.
TEST(PeriodicDecimate, MaxErrorBoundsTheDistanceModuloTheLattice) {
  const PeriodicTile input = waved(square_tile(24, 20));
  std::size_t last = 0;
  for (const double limit : {0.002, 0.01}) {
    PeriodicDomain domain(input, along(true, true, false));
    DecimateOptions options;
    options.max_error = limit;
    const DecimateResult r = decimate(domain.embedding(TileSides::free), domain.tile(), options);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    EXPECT_TRUE(copies_fit(domain));
    EXPECT_EQ(inverted(domain), 0U);
    EXPECT_EQ(r.stop, DecimateResult::Stop::bound);
    EXPECT_GT(r.collapsed, last) << "a larger error allows more";
    last = r.collapsed;
    const double bound = (1 + 1e-9) * limit * domain.diagonal();
    const PeriodicTile now = domain.tile_lists();
    EXPECT_LE(sampled_distance(triangles(input, {0}), triangles(now, {-1, 0, 1}), 4), bound);
    for (const auto& vertex : now.points) {
      double nearest = HUGE_VAL;
      for (const PlainTriangle& t : triangles(input, {-1, 0, 1}))
        nearest = std::min(nearest, distance(vertex, t));
      EXPECT_LE(nearest, bound);
    }
  }
}

/// In radians.
double least_angle(const PeriodicTile& tile) {
  double least = 4;
  for (std::size_t f = 0; f < tile.facets.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = tile.facets.facet(f);
      const Vec3 at(tile.points[v[i]]), a = Vec3(tile.points[v[(i + 1) % 3]]) - at,
                                        b = Vec3(tile.points[v[(i + 2) % 3]]) - at;
      least = std::min(least, std::atan2(cross(a, b).norm(), dot(a, b)));
    }
  return least;
}

TEST(RemeshTile, WithFreeSidesIsBetterThanWithFlatAndFrozenOnes) {
  std::map<TileSides, double> angle;
  for (const TileSides sides : {TileSides::frozen, TileSides::flat, TileSides::free}) {
    PeriodicDomain domain(shaken(square_tile(12, 5), 0.02), along(true, true, false));
    std::size_t frozen = 0;
    for (const PeriodicSide& side : domain.sides()) frozen += side.master.size();
    TileRemeshOptions options;
    options.length = 0.1;
    options.sides = sides;
    (void)remesh(domain, options);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), (std::vector<long>{1, 2, 1}));
    EXPECT_TRUE(copies_fit(domain));
    EXPECT_EQ(inverted(domain), 0U);
    EXPECT_NEAR(size(domain), 1, 1e-12);
    angle[sides] = least_angle(domain.tile_lists());
    for (const PeriodicSide& side : domain.sides()) frozen -= side.master.size();
    EXPECT_TRUE(frozen == 0 || sides != TileSides::frozen);
    EXPECT_EQ(domain.has_flat_sides(), sides != TileSides::free);
  }
  EXPECT_LT(angle[TileSides::frozen], angle[TileSides::flat]);
  EXPECT_LT(angle[TileSides::frozen], angle[TileSides::free]);
}

TEST(RemeshTile, KeepsCornersOfInterfacesThatCrossItsSides) {
  for (const TileSides sides : {TileSides::flat, TileSides::free}) {
    PeriodicTile tile = square_tile(10, 10);  // with a square of half its width, in its corners
    for (std::size_t f = 0; f < tile.facets.size(); ++f) {
      Vec3 middle{};
      for (const Index v : tile.facets.facet(f)) middle += Vec3(tile.points[v]) / 3;
      const auto is_in = [](double x) { return x < 0.3 || x > 0.8; };
      tile.regions.push_back(is_in(middle[0]) && is_in(middle[1]) ? 5 : 4);
    }
    PeriodicOptions gluing = along(true, true, false);
    gluing.interfaces = true;
    gluing.corner_angle = 0.5;
    PeriodicDomain domain(tile, gluing);
    TileRemeshOptions options;
    options.length = 0.07;
    options.sides = sides;
    (void)remesh(domain, options);
    double area = 0;
    const Mesh& mesh = domain.tree().mesh(domain.tile());
    for (Index f = 0; f < mesh.capacity(2); ++f)
      if (mesh.is_live(2, f) && domain.region(f) == 5) area += signed_measure(domain, f, {0, 0, 1});
    EXPECT_NEAR(area, 0.25, 1e-9);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  }
}

/// A disc, and a strip with straight sides beside it.
PeriodicTile disc_and_strip(Index n) {
  PeriodicTile tile = square_tile(n, n);
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    Vec3 middle{};
    for (const Index v : tile.facets.facet(f)) middle += Vec3(tile.points[v]) / 3;
    const bool in_disc = std::hypot(middle[0] - 0.6, middle[1] - 0.5) < 0.28;
    tile.regions.push_back(middle[0] < 0.25 ? 3 : in_disc ? 2 : 1);
  }
  return tile;
}

TEST(RemeshTile, GivesRegionsTheirAreasBackAndKeepsStraightInterfacesStraight) {
  for (const TileSides sides : {TileSides::flat, TileSides::free, TileSides::frozen}) {
    PeriodicOptions gluing = along(true, true, false);
    gluing.interfaces = true;
    PeriodicDomain domain(disc_and_strip(20), gluing);
    const auto before = sizes(domain);
    TileRemeshOptions options;
    options.length = 0.12;  // more than twice that of the steps of the disc's outline
    options.sides = sides;
    (void)remesh(domain, options);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    EXPECT_TRUE(copies_fit(domain));
    EXPECT_EQ(inverted(domain), 0U);
    for (const auto& [region, area] : sizes(domain)) EXPECT_NEAR(area, before.at(region), 1e-8) << region;
    const Mesh& mesh = domain.tree().mesh(domain.tile());
    for (Index e = 0; e < mesh.capacity(1); ++e) {
      if (!mesh.is_live(1, e)) continue;
      const Dart d = mesh.dart_of(1, e), beyond = mesh.switch_dart(d, 2);
      if (beyond == no_dart) continue;
      const auto one = domain.region(mesh.facet(d)), other = domain.region(mesh.facet(beyond));
      if (std::max(one, other) != 3 || one == other) continue;
      const double x = domain.positions()[mesh.vertex(d)][0];
      EXPECT_LT(std::abs(x - std::round(x / 0.25) * 0.25), 1e-12);
    }
  }
}

TEST(RemeshTile, OfTetrahedraIsACallersMistake) {
  PeriodicDomain domain(cube_tile(4), along(true, true, true));
  TileRemeshOptions options;
  options.length = 0.1;
  EXPECT_THROW((void)remesh(domain, options), UsageError);
}

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
