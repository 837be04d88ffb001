// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Parses a MEDIT file (`MeshVersionFormatted`; text). References of elements are their tags; those of
/// vertices are the soup's point_tags. Corners and RequiredVertices become tagged vertices with flags;
/// Ridges, RequiredEdges, RequiredTriangles and RequiredTetrahedra become flags. Points of a two-dimensional
/// mesh get z = 0. Sections with other names (Normals, Tangents, …) are left out. Messages name `path`.
/// \throw InputError `FILE:LINE: what; what to do`, also for volume elements other than tetrahedra.
SimplexSoup parse_medit(std::string_view bytes, const std::filesystem::path& path,
                        const ReadOptions& options = {});

}  // namespace multimesh::io
