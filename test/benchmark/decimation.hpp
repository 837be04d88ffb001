// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "test/benchmark/surface_tree.hpp"

namespace multimesh::bench {

/// The result of a run; two runs with the same sequence of collapses have equal checksums.
struct Decimation {
  std::size_t collapses = 0;
  std::size_t faces = 0;  ///< left over
  double checksum = 0;    ///< of the vertex positions
};

/// Shortest edge first, midpoint placement, until at most `faces` are left. One queue (WorkQueue) and the
/// same updates in both; `mesh` and `tree` start from the same shape.
Decimation decimate_bare(SurfaceMesh& mesh, std::size_t faces);
Decimation decimate_tree(SurfaceTree& tree, std::size_t faces);
/// OpenMesh's own decimater with its edge-length module (half-edge collapses).
Decimation decimate_by_decimater(SurfaceMesh& mesh, std::size_t faces);

}  // namespace multimesh::bench
