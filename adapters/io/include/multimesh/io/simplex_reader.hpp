// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Reads tagged simplices. The format is known by the content where that says it, whatever the extension:
/// Gmsh (.msh), MEDIT and MFEM (.mesh), VTK (.vtu, .vtp, .vtk); otherwise by the extension: .node or .ele
/// (TetGen's pair of files), .obj (with its lines as edges), .ply, .stl, .off. Any of them may be gzipped,
/// whatever its name. Points that no simplex names are kept; simplices that name a point twice are left out,
/// and refused when they are more than `options` allows. Cost: memory for the file and for the soup. \throw
/// InputError naming file and line or element, and what to do: for what is missing, truncated, foreign
///   or damaged, coordinates that are not finite, volumes other than tetrahedra, files without simplices.
SimplexSoup read_simplices(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from bytes in memory, not gzipped; TetGen's pairs of files cannot be read so. `path` is what
/// messages name, and its extension the format where the content does not say it.
SimplexSoup parse_simplices(std::string_view bytes, const std::filesystem::path& path,
                            const ReadOptions& options = {});

}  // namespace multimesh::io
