// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "adapters/tetgen/naming.hpp"

namespace multimesh::tetgen {

/// Per region, the name of its seed or of what encloses it, see name_parts(); empty: none. Names may repeat.
std::vector<std::string> region_names(const Tetrahedralization& mesh, const TriangleNames& names);

}  // namespace multimesh::tetgen
