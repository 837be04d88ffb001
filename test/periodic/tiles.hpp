// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh::test {

/// The unit square in n x m squares of two triangles; vertex (i,j) has the index i (m + 1) + j.
PeriodicTile square_tile(Index n, Index m);
/// The unit cube in n^3 cubes of six tetrahedra around their main diagonals (Kuhn); vertex (i,j,k) has the
/// index (i (n + 1) + j) (n + 1) + k.
PeriodicTile cube_tile(Index n);

PeriodicOptions along(bool x, bool y, bool z, bool refine = false);

/// What the InputError says, or an empty string if there is none.
std::string refusal(const PeriodicTile& tile, const PeriodicOptions& options);

/// Edges of the root that may be collapsed.
std::size_t legal_edges(PeriodicDomain& domain);

/// Whether all copies of each vertex are exactly lattice vectors apart, relative to one of them.
bool copies_fit(const PeriodicDomain& domain);
/// Facets of the tile without positive volume, or without positive area as seen against the mean normal.
std::size_t inverted(const PeriodicDomain& domain);
/// Volume, or area as seen so.
double size(const PeriodicDomain& domain);
/// Area or volume by region; in a tile of triangles as seen along z.
std::map<PeriodicTile::Region, double> sizes(const PeriodicDomain& domain);

}  // namespace multimesh::test
