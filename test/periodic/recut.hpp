// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <random>

#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh::test {

/// A tile of a known torus: a grid of squares or cubes whose facets have been moved by lattice vectors, each
/// block of them as a whole. The torus has n^d vertices, and every side has its partner some lattice vector
/// away.
struct RecutTorus {
  PeriodicTile tile;
  PeriodicOptions options;  ///< the periods: another basis of the lattice than the grid's
  std::array<std::size_t, 4> simplices{};
};

enum class Recut {
  rows,    ///< each half is shifted against the other one: bricks
  blocks,  ///< the blocks of a coarse grid go anywhere nearby: jagged sides
  plane,   ///< what lies beyond an oblique plane is moved to the other side: cut corners, as of a hexagon
};

/// Used by GoogleTest, which would otherwise print the bytes of a parameter.
inline void PrintTo(Recut r, std::ostream* out) {
  *out << (r == Recut::rows ? "rows" : r == Recut::blocks ? "blocks" : "plane");
}

/// \pre n >= 4, d is 2 or 3
RecutTorus recut_torus(int d, Index n, Recut how, std::mt19937& random);

}  // namespace multimesh::test
