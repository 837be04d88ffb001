// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/periodic_domain/labelled_tile.hpp"

namespace multimesh {

/// Whether tetrahedra need not be cut, given that the glued tile need not. Then they are manifold at vertices
/// without copies, because they look the same there; the links of the others must be disks or spheres.
/// \pre the glued tile is a simplicial complex. Cost: linear
bool is_manifold_tile(const LabelledTile& tile);

}  // namespace multimesh
