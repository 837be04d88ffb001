// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "multimesh/cut.hpp"

namespace multimesh {

struct BettiNumbers {
  std::size_t components = 0;  ///< connected, possibly at only one point
  std::size_t handles = 0;     ///< independent loops, modulo 2
};

/// The first two Betti numbers of a complex given by its facets. It need not be manifold: only its vertices,
/// edges and triangles count. Unused vertices do not. Cost: nearly linear for meshes
BettiNumbers betti_numbers(const FacetList& facets);

}  // namespace multimesh
