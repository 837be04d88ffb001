// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/read_options.hpp"

namespace multimesh::io {

/// Parses a text file in Geomview's OFF format and its variants with normals, colours and texture coordinates
/// of vertices (NOFF, COFF, STOFF, …), comments and polygons. Colours of faces are left out. Messages name
/// `path`.
/// \throw InputError `FILE:LINE: what; what to do`, for binary and four-dimensional variants, and as
/// check_soup
///   does.
PolygonSoup parse_off(std::string_view bytes, const std::filesystem::path& path,
                      const ReadOptions& options = {});

}  // namespace multimesh::io
