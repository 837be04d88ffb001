// SPDX-License-Identifier: BSD-3-Clause
// Periodic tiles are decimated across their sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "multimesh/algorithms/decimate_domain.hpp"
#include "multimesh/algorithms/tile_topology.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh {
namespace {

constexpr TileSides all_sides[] = {TileSides::flat, TileSides::free, TileSides::frozen};

PeriodicOptions with_interfaces(bool x, bool y, bool z) {
  PeriodicOptions o = test::along(x, y, z);
  o.interfaces = true;
  return o;
}

/// Makes region 2 of the facets whose centre is in a ball around the given point of the torus.
void add_ball(PeriodicTile& tile, const std::array<double, 3>& centre, double radius) {
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    double squared = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      double x = 0;
      const auto corners = tile.facets.facet(f);
      for (const Index v : corners) x += tile.points[v][i] / static_cast<double>(corners.size());
      squared += std::pow(std::remainder(x - centre[i], 1), 2);
    }
    tile.regions.push_back(squared < radius * radius ? 2 : 1);
  }
}

/// Bends a box without moving its sides out of their planes.
void bend(PeriodicTile& tile) {
  const auto wave = [](double x) { return std::sin(2 * std::numbers::pi * x) / 40; };
  for (auto& p : tile.points) {
    const auto [x, y, z] = p;
    p = {x + wave(x) * std::cos(2 * std::numbers::pi * y), y + wave(y), z + wave(z)};
  }
}

SurfaceDecimateOptions to_faces(std::size_t faces) {
  SurfaceDecimateOptions o;
  o.faces = faces;
  o.max_aspect_ratio = 20;
  return o;
}

/// Whether all sides lie in the planes of the unit box.
bool has_box(const PeriodicDomain& domain) {
  const PeriodicTile tile = domain.tile_lists();
  return std::ranges::all_of(domain.sides(), [&](const PeriodicSide& side) {
    for (std::size_t i = 0; i < 3; ++i)
      if (side.shift[i] != 0)
        for (const Index v : side.slave.corners)
          if (tile.points[v][i] != 1) return false;
    return true;
  });
}

void expect_same(const TileTopology& before, const PeriodicDomain& domain, double sizes) {
  EXPECT_EQ(differences(before, topology_of(domain), sizes), std::vector<std::string>{});
  EXPECT_TRUE(test::copies_fit(domain));
  EXPECT_EQ(test::inverted(domain), 0U);
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  const PeriodicDomain again(domain.tile_lists(), domain.gluing());
  EXPECT_EQ(again.report().euler, before.euler);
}

TEST(DecimateTile, TrianglesAcrossTheirSides) {
  for (const TileSides sides : all_sides) {
    PeriodicTile tile = test::square_tile(12, 12);
    add_ball(tile, {0, 0.5, 0}, 0.3);  // across a side
    bend(tile);
    for (auto& p : tile.points) p[2] = 0;
    PeriodicDomain domain(tile, with_interfaces(true, true, false));
    const TileTopology before = topology_of(domain);
    const std::size_t sides_before = domain.sides().front().master.size();
    const DomainDecimateResult r = decimate(domain, sides, to_faces(140));
    EXPECT_EQ(r.surface.stop, DecimateResult::Stop::faces);
    EXPECT_EQ(r.surface.faces_after, domain.tile_lists().facets.size());
    EXPECT_FALSE(r.tetrahedra);
    expect_same(before, domain, 0.05);
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
    PeriodicTile tile = test::cube_tile(8);
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
    expect_same(before, domain, 0.2);
    if (sides != TileSides::free) {
      EXPECT_TRUE(has_box(domain));
    }
  }
}

// A listed face in a side is decimated once, and both copies have their tags.
TEST(DecimateTile, ListedFacesInTheSides) {
  constexpr Index n = 6;
  PeriodicTile tile = test::cube_tile(n);
  const PeriodicDomain plain(tile, test::along(true, true, true));
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
  PeriodicDomain domain(tile, test::along(true, true, true));
  const TileTopology before = topology_of(domain);
  const std::size_t faces = 2 * n * n;
  const DomainDecimateResult r = decimate(domain, TileSides::flat, to_faces(faces / 2));
  EXPECT_EQ(r.surface.faces_before, faces);
  EXPECT_EQ(r.surface.faces_after, faces / 2);
  expect_same(before, domain, 1e-9);
  EXPECT_TRUE(has_box(domain));
  const std::vector<PeriodicTile::Region> tags = domain.tile_lists().listed[2].tags;
  EXPECT_EQ(std::ranges::count(tags, 7), static_cast<long>(faces / 2));
  EXPECT_EQ(std::ranges::count(tags, 8), static_cast<long>(faces / 2));
}

TEST(DecimateTile, WithoutSurfaceIsRefused) {
  PeriodicDomain domain(test::cube_tile(4), test::along(true, true, true));
  EXPECT_THROW((void)decimate(domain, TileSides::flat, to_faces(10)), InputError);
}

}  // namespace
}  // namespace multimesh
