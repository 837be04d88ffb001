// SPDX-License-Identifier: BSD-3-Clause
// Periodic tiles are decimated across their sides.
#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/algorithms/decimate_domain.hpp"
#include "test/improve/made_tile.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

SurfaceDecimateOptions to_faces(std::size_t faces) {
  SurfaceDecimateOptions o;
  o.faces = faces;
  o.max_aspect_ratio = 20;
  return o;
}

TEST(DecimateTile, TrianglesAcrossTheirSides) {
  for (const TileSides sides : all_sides) {
    PeriodicTile tile = square_tile(12, 12);
    add_ball(tile, {0, 0.5, 0}, 0.3);  // across a side
    bend(tile);
    PeriodicDomain domain(tile, with_interfaces(true, true, false));
    const TileTopology before = topology_of(domain);
    const std::size_t sides_before = domain.sides().front().master.size();
    const DomainDecimateResult r = decimate(domain, sides, to_faces(140));
    EXPECT_EQ(r.surface.stop, DecimateResult::Stop::faces);
    EXPECT_EQ(r.surface.faces_after, domain.tile_lists().facets.size());
    EXPECT_FALSE(r.tetrahedra);
    EXPECT_EQ(fault(before, domain, 0.05), "");
    EXPECT_TRUE(has_box(domain));  // straight lines cost least
    if (sides == TileSides::frozen) {
      EXPECT_EQ(domain.sides().front().master.size(), sides_before);
    } else {
      EXPECT_LT(domain.sides().front().master.size(), sides_before);
    }
  }
}

TEST(DecimateTile, TheSurfaceOfTetrahedraThatFollow) {
  for (const TileSides sides : all_sides) {
    PeriodicTile tile = cube_tile(8);
    add_ball(tile, {0, 0, 0.5}, 0.36);  // across an edge of the box
    bend(tile);
    PeriodicDomain domain(tile, with_interfaces(true, true, true));
    const TileTopology before = topology_of(domain);
    SurfaceDecimateOptions options = to_faces(150);
    options.passes_at_end = 5;
    const DomainDecimateResult r = decimate(domain, sides, options);
    EXPECT_GT(r.surface.collapsed, 20U);
    ASSERT_TRUE(r.tetrahedra);
    EXPECT_LT(domain.tile_lists().facets.size(), tile.facets.size());
    EXPECT_EQ(fault(before, domain, 0.2), "");
    if (sides != TileSides::free) {
      EXPECT_TRUE(has_box(domain));
    }
  }
}

// A listed face in a side is decimated once, and both copies have their tags.
TEST(DecimateTile, ListedFacesInTheSides) {
  constexpr Index n = 6;
  PeriodicTile tile = cube_tile(n);
  const PeriodicDomain plain(tile, along(true, true, true));
  for (const PeriodicSide& side : plain.sides()) {
    if (side.shift[0] == 0) continue;
    for (const FacetList* faces : {&side.master, &side.slave}) {
      auto& listed = tile.listed[2];
      listed.simplices.corners.insert(listed.simplices.corners.end(), faces->corners.begin(),
                                      faces->corners.end());
      listed.simplices.vertices = faces->vertices;
      listed.tags.resize(listed.tags.size() + faces->size(), faces == &side.master ? 7 : 8);
    }
  }
  PeriodicDomain domain(tile, along(true, true, true));
  const TileTopology before = topology_of(domain);
  const std::size_t faces = 2 * n * n;
  const DomainDecimateResult r = decimate(domain, TileSides::flat, to_faces(faces / 2));
  EXPECT_EQ(r.surface.faces_before, faces);
  EXPECT_EQ(r.surface.faces_after, faces / 2);
  EXPECT_EQ(fault(before, domain, 1e-9), "");
  EXPECT_TRUE(has_box(domain));
  const std::vector<PeriodicTile::Region> tags = domain.tile_lists().listed[2].tags;
  EXPECT_EQ(std::ranges::count(tags, 7), static_cast<long>(faces / 2));
  EXPECT_EQ(std::ranges::count(tags, 8), static_cast<long>(faces / 2));
}

TEST(DecimateTile, WithoutSurfaceIsRefused) {
  PeriodicDomain domain(cube_tile(4), along(true, true, true));
  EXPECT_THROW((void)decimate(domain, TileSides::flat, to_faces(10)), InputError);
}

}  // namespace
}  // namespace multimesh::test
