// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::test {

/// What can be counted of tetrahedra without any of the library's code.
struct TetFacts {
  double volume = 0, least = 0, most = 0;  ///< volumes: all, the smallest, the largest
  std::size_t border_faces = 0;            ///< with one tetrahedron
  std::size_t bad_faces = 0;               ///< with three or more, or two on the same side
  std::size_t unused_points = 0;
};

TetFacts facts_of(const tetgen::TetrahedraList& mesh);

}  // namespace multimesh::test
