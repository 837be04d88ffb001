// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "multimesh/permutation.hpp"

namespace multimesh {

/// Index of a simplex in its mesh; stable until the mesh is compacted.
using Index = std::uint32_t;
inline constexpr Index no_index = ~Index{0};

/// A chain vertex < edge < ... < facet of one mesh; equivalently, an ordering (v0,...,vd) of the vertices of
/// one facet, whose first j+1 vertices span its j-simplex. The code is opaque: each mesh type has its own. A
/// d-simplex has (d+1)! darts: 2, 6, 24. (Codimensional MultiMeshing, section 3.)
enum class Dart : std::uint32_t { none = ~std::uint32_t{0} };
inline constexpr Dart no_dart = Dart::none;

constexpr std::uint32_t code(Dart d) noexcept {
  return static_cast<std::uint32_t>(d);
}

/// The stored pair of a containment map, one per child facet. With own = (v0,...,vk), the map takes v0,...,vk
/// to the first k+1 vertices of `parent`.
struct Anchor {
  Dart own = no_dart;
  Dart parent = no_dart;
  friend bool operator==(const Anchor&, const Anchor&) = default;
};

/// A buffer owned by the caller, so that a query in a hot loop allocates nothing in the steady state.
using DartBuffer = std::vector<Dart>;

/// The ends of an edge dart (a, b, ...): a is its vertex.
enum class End : std::uint8_t { a, b };

}  // namespace multimesh
