// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/tetgen/tetrahedralize.hpp"

namespace multimesh::tetgen {

/// Which of the requested sizes and qualities a mesh misses, by how much and where; one sentence each. Cost:
/// sorting the edges.
/// \param surface the triangles that lie on the surface
std::vector<std::string> missed_bounds(const TetrahedraList& mesh, const FacetList& surface,
                                       const TetrahedralizeOptions& options);

}  // namespace multimesh::tetgen
