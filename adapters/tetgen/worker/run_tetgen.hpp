// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapters/tetgen/worker/request.hpp"

namespace multimesh::tetgen::worker {

/// Tetrahedralizes the surface and writes the reply. Ends the process if TetGen fails.
void tetrahedralize(Request& request);

/// Looks for triangles that intersect others, and writes the first pairs as the reply.
void find_intersections(Request& request);

}  // namespace multimesh::tetgen::worker
