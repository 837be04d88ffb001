// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Reads tagged simplices. The content determines the format where it can, whatever the extension: Gmsh
/// (.msh), MEDIT and MFEM (.mesh), VTK (.vtu, .vtp, .vtk); otherwise the extension: .node or .ele (TetGen's
/// pair of files), .obj (with its lines as edges), .ply, .stl, .off. Any of them may be gzipped, whatever its
/// name. Points that no simplex names are kept; simplices that name a point twice are left out, and refused
/// when they are more than `options` allows. Cost: memory for the file and for the soup.
/// \throw InputError naming file and line or element, and what to do: for missing, truncated, foreign or
/// damaged files, coordinates that are not finite, volumes other than tetrahedra, files without simplices.
SimplexSoup read_simplices(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from bytes in memory, not gzipped; not for TetGen's pairs of files. Messages name `path`; its
/// extension determines the format where the content does not.
SimplexSoup parse_simplices(std::string_view bytes, const std::filesystem::path& path,
                            const ReadOptions& options = {});

}  // namespace multimesh::io
