// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "adapters/tetgen/worker_call.hpp"
#include "multimesh/tetgen/facets.hpp"

namespace multimesh::tetgen {

/// A face of the tetrahedra on a facet, oriented like it.
struct FacetFace {
  std::array<Index, 3> corners{};
  Index facet = no_index;
};

/// The parts into which facets divide space.
struct Regions {
  /// Per tetrahedron; no_index: outside. Numbered by their first facet, the one behind it first.
  std::vector<Index> of_tet;
  std::vector<long double> volume;  ///< per region
  std::vector<Sides> sides;         ///< per facet
  std::vector<FacetFace> faces;     ///< by ascending facet
};

struct RegionOptions {
  bool split_surface = false;  ///< facets may be covered by several faces
  /// Facets that may have no face, because both of their sides were left out; empty: none.
  std::vector<bool> may_be_missing{};
};

/// Finds the regions: what can be reached from the border of the tetrahedra without crossing a facet is the
/// outside. Verifies TetGen's treatment of the facets: tetrahedra are positive and meet in faces, facets are
/// faces or, when they may be split, covered by faces; a facet has one region on each side; regions have the
/// volume that their facets enclose. Cost: sorting the faces. \throw WorkerError (bad_result)
Regions find_regions(const RawTetrahedra& raw, const Facets& facets, const RegionOptions& options);

}  // namespace multimesh::tetgen
