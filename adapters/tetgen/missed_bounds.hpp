// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "adapters/tetgen/tetrahedralize.hpp"

namespace multimesh::tetgen {

/// Which of the sizes and qualities that were asked for the result misses, by how much and where; one
/// sentence each. Cost: sorting the edges.
std::vector<std::string> missed_bounds(const Tetrahedralization& mesh, const TetrahedralizeOptions& options);

}  // namespace multimesh::tetgen
