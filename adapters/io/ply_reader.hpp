// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/read_options.hpp"

namespace multimesh::io {

/// Reads a PLY file, ASCII or binary of either byte order: vertex x y z, red green blue, texture coordinates
/// per vertex (s t, u v, texture_u texture_v) or per corner (face list `texcoord`; equal ones at a vertex
/// become one), face vertex_indices or vertex_index, tristrips vertex_indices (-1 ends a strip). Anything
/// else in the file is left out and named in one warning. Integer colours are scaled to [0, 1] by the range
/// of their type. An ASCII file has one row per line, as exporters write it: a line with more or fewer values
/// than the header declares is an error, because their meaning would be a guess. \throw InputError naming
/// the line, or in a binary file the vertex or face counted from 0; see read_obj.
PolygonSoup read_ply(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from bytes in memory. Messages name `path`.
PolygonSoup parse_ply(std::string_view bytes, const std::filesystem::path& path,
                      const ReadOptions& options = {});

}  // namespace multimesh::io
