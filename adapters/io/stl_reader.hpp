// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/read_options.hpp"

namespace multimesh::io {

/// Parses an STL file, text or binary; a binary one is recognized by its size, even if its header
/// begins with `solid`. Corners at exactly equal coordinates become one position
/// (notes.merged_positions); normals, names and attributes are left out. Messages name `path`. Cost:
/// O(\#F) expected.
/// \throw InputError naming the line (text) or the face (binary), for a truncated file, coordinates
/// that are not finite, and as check_soup.
PolygonSoup parse_stl(std::string_view bytes, const std::filesystem::path& path,
                      const ReadOptions& options = {});

}  // namespace multimesh::io
