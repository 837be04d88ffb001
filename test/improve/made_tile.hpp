// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "multimesh/algorithms/tile_topology.hpp"
#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh::test {

constexpr TileSides all_sides[] = {TileSides::flat, TileSides::free, TileSides::frozen};

PeriodicOptions with_interfaces(bool x, bool y, bool z);

/// Makes region 2 of the facets whose centre is in a ball around the given point of the unit torus, region 1
/// of the others.
void add_ball(PeriodicTile& tile, const std::array<double, 3>& centre, double radius);
/// Bends a unit box without moving its sides out of their planes; in the plane of x and y, a unit square.
void bend(PeriodicTile& tile);
/// Removes the tetrahedra in the box from one third to two thirds. \pre cube_tile of a multiple of 3
void cut_hole(PeriodicTile& tile);

/// Whether all sides lie in the planes of the unit box.
bool has_box(const PeriodicDomain& domain);

/// What is wrong with a tile after an algorithm; empty: nothing. `sizes`: by how much of itself the size of a
/// region may have changed.
std::string fault(const TileTopology& before, const PeriodicDomain& domain, double sizes);

}  // namespace multimesh::test
