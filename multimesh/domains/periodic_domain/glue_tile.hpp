// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/domains/periodic_domain/labelled_tile.hpp"

namespace multimesh {

/// A tile and the root that results when its copies of vertices are glued: the same facet by facet, manifold
/// and consistently oriented.
struct GluedTile {
  FacetList tile, root;
  std::vector<Index> source;      ///< per vertex of the tile: that of the labelled tile
  std::vector<Index> root_class;  ///< per vertex of the root: its class
};

/// The box of a tile, and which of its vertices are one; refined if requested.
/// \throw InputError as PeriodicDomain
struct PreparedTile {
  LabelledTile tile;
  Lattice lattice;
  double diagonal;
};
PreparedTile prepare_tile(const PeriodicTile& input, const PeriodicOptions& options, PeriodicReport& report);

/// Cuts both where they are not manifold and turns all facets round until their volume (area as seen from
/// one side) is positive on the whole. \throw InputError if sides do not match facet by facet
GluedTile glue_tile(const LabelledTile& tile, PeriodicReport& report);

}  // namespace multimesh
