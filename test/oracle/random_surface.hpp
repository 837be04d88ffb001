// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <random>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

enum class Surface { kDisk, kSphere, kAnnulus, kTorus, kHoledTorus, kMoebius };
inline constexpr int kNumberOfSurfaces = 6;

/// The smallest triangulation, or nearly: triangle, tetrahedron, ring of 6, 7-vertex torus (14), that without
/// a facet, 5-vertex Möbius band. Consistently oriented where that is possible.
Complex base_surface(Surface kind);

/// 0..n-1. Unlike std::uniform_int_distribution the same on every platform.
///
/// \pre n > 0
std::size_t pick(std::mt19937_64& rng, std::size_t n);

/// Whether an event of `percent` % happens.
bool chance(std::mt19937_64& rng, std::size_t percent);

/// A random triangulation: the base surface, splits until there are some facets more than requested, swaps,
/// and collapses that satisfy the link condition. Has `facets` facets, one less for parity, or more where
/// that many are not enough (the torus needs 14).
Complex random_surface(Surface kind, std::size_t facets, std::mt19937_64& rng);

}  // namespace multimesh::oracle
