// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace multimesh::files {

/// Whether the extension is that of a format for surfaces only, perhaps with texture coordinates; so is that
/// of `a.obj.gz`.
bool is_surface_format(const std::filesystem::path& path);

// For help texts and messages: formats that are read as tetrahedra, and as anything; formats to which
// surfaces and tetrahedra are written.
constexpr const char* simplex_formats = "MSH, MEDIT, MFEM, VTU, VTP, VTK, .node/.ele; also gzipped";
constexpr const char* all_formats =
    "OBJ, PLY, STL, OFF, MSH, MEDIT, MFEM, VTU, VTP, VTK, .node/.ele; also gzipped";
constexpr const char* written_surface_formats = "OBJ, or PLY, STL, OFF, which have room for less";
constexpr const char* written_simplex_formats = "MSH, MEDIT (.mesh), VTU";

}  // namespace multimesh::files
