// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "multimesh/domains/periodic_domain/labelled_tile.hpp"

namespace multimesh {

/// Refuses sides that gluing puts on each other although they do not match: a face of only one facet whose
/// middle lies on another such face, a lattice vector away; or nearly lies on it (0.15 of their least
/// altitudes), and they face each other. Left open, such sides would be taken for the surface of the
/// material. \throw InputError naming both facets. Cost: sorting the faces within reach of a vector
void require_no_open_sides(const LabelledTile& tile, const Lattice& lattice,
                           std::span<const LatticeVector> vectors, double tolerance);

}  // namespace multimesh
