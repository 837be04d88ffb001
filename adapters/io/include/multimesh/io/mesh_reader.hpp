// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/read_options.hpp"

namespace multimesh::io {

/// Reads a surface in the format that the extension names, in any case: .obj, .ply, .stl or .off; each may be
/// gzipped, with or without a further .gz.
/// \throw InputError as read_obj, read_ply, parse_stl and parse_off do, for damaged gzip data, and for any
/// other
///   extension.
PolygonSoup read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from bytes in memory, not gzipped. Messages name `path`; its extension determines the format.
PolygonSoup parse_mesh(std::string_view bytes, const std::filesystem::path& path,
                       const ReadOptions& options = {});

}  // namespace multimesh::io
