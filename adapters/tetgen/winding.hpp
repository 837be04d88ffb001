// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "adapters/tetgen/regions.hpp"

namespace multimesh::tetgen {

/// How often the surface goes round each region, and what had to be assumed for it.
struct Winding {
  std::vector<int> numbers;    ///< per region; 0: empty
  std::vector<Index> turned;   ///< facets oriented against most others of their shell
  std::vector<Index> assumed;  ///< regions whose shell has no consistent orientation: filled
};

/// Winding numbers by the orientation of the facets, shell by shell; a shell is connected through points.
/// Facets that are listed with both orientations have a part on each side and count as no step. A shell in
/// which more than one facet in ten is oriented against the others, or in which steps contradict each other,
/// is inconclusive; what it encloses is taken as filled. If it encloses several regions, the file lists
/// interfaces of materials, whose orientation is arbitrary: then everything enclosed by any shell is filled.
Winding find_winding(const Facets& facets, const std::vector<Sides>& sides, std::size_t regions);

}  // namespace multimesh::tetgen
