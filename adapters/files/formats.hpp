// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace multimesh::files {

/// Whether the extension is that of a format that holds surfaces only, perhaps with texture coordinates.
/// `a.obj.gz` is one.
bool is_surface_format(const std::filesystem::path& path);

/// Formats by name, for help texts and messages.
constexpr const char* surface_formats = "OBJ, PLY, STL, OFF";
constexpr const char* simplex_formats = "MSH, MEDIT, MFEM, VTU, VTP, VTK, .node/.ele";
constexpr const char* written_simplex_formats = "MSH, MEDIT (.mesh), VTU";

}  // namespace multimesh::files
