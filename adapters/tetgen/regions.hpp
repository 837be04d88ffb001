// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "adapters/tetgen/tetrahedralize.hpp"
#include "adapters/tetgen/worker_call.hpp"

namespace multimesh::tetgen {

/// The parts into which a surface cuts tetrahedra.
struct Regions {
  std::vector<Index> of_tet;        ///< numbered by their first tetrahedron
  std::vector<int> winding;         ///< per region
  std::vector<long double> volume;  ///< per region
  std::vector<SurfaceFace> faces;   ///< by ascending triangle
};

/// Finds the regions, and verifies what TetGen made of the triangles: tetrahedra are positive and meet in
/// faces, triangles are faces or, when the surface may be split, covered by faces; nothing else bounds the
/// tetrahedra; the volumes, times the winding numbers, are what the surface encloses. Cost: sorting the
/// faces. \throw WorkerError (bad_result)
Regions find_regions(const RawTetrahedra& raw, std::span<const Index> corners, bool split_surface);

}  // namespace multimesh::tetgen
