// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>

#include "multimesh/operations.hpp"

namespace multimesh::improvement {

enum class Kind : std::uint8_t { split, collapse, edge_swap, face_swap, smoothing };
inline constexpr std::size_t n_kinds = 5;

/// Why a candidate was not taken. Reasons up to `legality` cost only reading the star and change nothing.
enum class Why : std::uint8_t {
  worse,     ///< the worst tetrahedron would not improve
  inverted,  ///< one would be inverted or flat
  held,      ///< the surface, a curve, a locked vertex or region would change
  length,    ///< an edge would be too long or too short
  legality,  ///< the tree refused: topology would change
};
inline constexpr std::size_t n_reasons = 5;

struct Count {
  std::size_t tried = 0, done = 0;
  std::array<std::size_t, n_reasons> refused{};
};

using Counts = std::array<Count, n_kinds>;

}  // namespace multimesh::improvement
