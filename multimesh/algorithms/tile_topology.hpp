// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "multimesh/algorithms/betti_numbers.hpp"
#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh {

/// What algorithms keep of a periodic tile: facts of its glued mesh, which no choice of the cell changes.
/// They are read from the lists of the tile and its copies, as they are written, not from the glued mesh.
struct TileTopology {
  std::array<std::size_t, 4> simplices{};  ///< of the glued mesh, by dimension
  std::vector<std::size_t> with_copies;    ///< [n]: its vertices with n copies in the tile
  std::size_t improper = 0;  ///< edges with the same ends, facets with the same vertices, faces of three
                             ///< facets: it is no simplicial complex then
  long euler = 0;            ///< of the glued mesh
  BettiNumbers betti;        ///< of it
  long surface_euler = 0;    ///< of the boundary of the material
  long interface_euler = 0;  ///< of the faces between different regions
  BettiNumbers surface, interface;
  std::map<PeriodicTile::Region, double> sizes;  ///< volumes or areas by region
  std::size_t inverted = 0;
  double mismatch = 0;  ///< of copies
};

/// Cost: linear
TileTopology topology_of(const PeriodicDomain& domain);

/// What has changed that should not, in words. `sizes`: by how much of itself the size of a region may
/// change.
std::vector<std::string> differences(const TileTopology& before, const TileTopology& after, double sizes);

}  // namespace multimesh
