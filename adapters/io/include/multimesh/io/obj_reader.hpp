// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/read_options.hpp"

namespace multimesh::io {

/// Reads a Wavefront OBJ file: v (with colours), vt, vn, f with positive and negative indices, o, g, usemtl,
/// s, mtllib; every other statement is left out, counted in the notes and named in one warning.
/// Coordinates are doubles, correctly rounded.
/// \throw InputError `FILE:LINE: what; what to do` for a missing, unreadable or foreign file, a number that
///   cannot be read, a vertex index that is 0 or out of range, a face with fewer than three corners, a file
///   without faces, and as check_soup does.
PolygonSoup read_obj(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from text in memory. Messages name `path`; mtllib names are looked up relative to it.
PolygonSoup parse_obj(std::string_view text, const std::filesystem::path& path,
                      const ReadOptions& options = {});

}  // namespace multimesh::io
