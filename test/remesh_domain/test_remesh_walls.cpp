// SPDX-License-Identifier: BSD-3-Clause
// The surface of the material and the interfaces of periodic tiles of tetrahedra are remeshed across the
// sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "multimesh/algorithms/remesh_domain.hpp"
#include "test/improve/made_tile.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

SurfaceRemeshOptions with_length(double length) {
  SurfaceRemeshOptions o;
  o.length = length;
  o.iterations = 6;
  o.passes_at_end = 5;
  return o;
}

TEST(RemeshWalls, InterfacesAcrossTheSides) {
  for (const TileSides sides : all_sides) {
    PeriodicTile tile = cube_tile(8);
    add_ball(tile, {0, 0, 0.5}, 0.36);  // across an edge of the box
    bend(tile);
    PeriodicDomain domain(tile, with_interfaces(true, true, true));
    const TileTopology before = topology_of(domain);
    const DomainRemeshResult r = remesh_walls(domain, sides, with_length(0.16));
    EXPECT_GT(r.surface.moves, 50U);
    EXPECT_GT(static_cast<double>(r.surface.edges_in_range),
              (sides == TileSides::frozen ? 0.5 : 0.65) * static_cast<double>(r.surface.edges));
    EXPECT_EQ(fault(before, domain, 1e-6), "");  // regions get their volumes back
    if (sides != TileSides::free) {
      EXPECT_TRUE(has_box(domain));
    }
  }
}

double from_third(double x) {
  return std::min(std::abs(x - 1. / 3), std::abs(x - 2. / 3));
}

// A hole in the shape of a cube keeps it.
TEST(RemeshWalls, EdgesOfTheSurfaceByTheFeatureAngle) {
  PeriodicTile tile = cube_tile(6);
  cut_hole(tile);
  PeriodicOptions options = along(true, true, true);
  options.feature_angle = 0.7;
  PeriodicDomain domain(tile, options);
  const Mesh& curves = domain.tree().mesh(domain.listed(1).value());
  EXPECT_EQ(curves.capacity(1), 24U);
  const TileTopology before = topology_of(domain);
  const NodeId walls = domain.add_walls().value();
  EXPECT_EQ(domain.add_walls(), walls);
  (void)remesh_walls(domain, TileSides::flat, with_length(0.1));
  EXPECT_EQ(fault(before, domain, 1e-9), "");
  const Mesh& surface = domain.tree().mesh(walls);
  std::size_t corners = 0, vertices = 0;
  for (Index v = 0; v < surface.capacity(0); ++v) {
    if (!surface.is_live(0, v)) continue;
    const Vec3 p = domain.place(walls, surface.dart_of(0, v));
    const double distances[] = {from_third(p[0]), from_third(p[1]), from_third(p[2])};
    EXPECT_LT(*std::ranges::min_element(distances), 1e-12);
    corners += *std::ranges::max_element(distances) < 1e-12;
    ++vertices;
  }
  EXPECT_EQ(corners, 8U);
  EXPECT_GT(vertices, 26U);  // as many were there
}

TEST(RemeshWalls, ATileWithoutSurfaceIsRefused) {
  PeriodicDomain domain(cube_tile(4), along(true, true, true));
  EXPECT_THROW((void)remesh_walls(domain, TileSides::flat, with_length(0.2)), InputError);
}

}  // namespace
}  // namespace multimesh::test
