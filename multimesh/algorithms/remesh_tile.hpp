// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh {

struct TileRemeshOptions : RemeshOptions {
  TileSides sides = TileSides::flat;
};

struct TileRemeshResult : RemeshResult {
  std::size_t dropped_listed = 0;  ///< what was listed in the sides, if they are free
};

/// Isotropic remeshing of a tile of triangles across its sides; all copies stay lattice vectors apart. Flat
/// sides are curves, and so are those that are not flat. Free ones dissolve: the tile is remeshed in other
/// cuts, and its new sides follow edges near the old ones; the domain is then replaced by another one, and
/// nodes and indices change. \throw UsageError for a tile of tetrahedra; InputError as remesh(), and for free
/// sides of a tile whose root had to be cut where it is not manifold
TileRemeshResult remesh(PeriodicDomain& domain, const TileRemeshOptions& options);

}  // namespace multimesh
