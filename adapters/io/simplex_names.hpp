// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace multimesh::io {

/// Names of simplices in messages, by dimension.
inline constexpr std::array<const char*, 4> simplex_names = {"vertex", "edge", "triangle", "tetrahedron"};
inline constexpr std::array<const char*, 4> simplex_plurals = {"vertices", "edges", "triangles",
                                                               "tetrahedra"};

}  // namespace multimesh::io
