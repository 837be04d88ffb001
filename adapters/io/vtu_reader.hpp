// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Parses an unstructured grid (.vtu) or poly data (.vtp) of VTK in XML, with arrays as text, base64 or
/// appended, compressed by zlib or not, of any number of pieces. The tag is the cell array of whole numbers
/// with a usual name (tag, region, material, medit:ref, gmsh:physical, …), otherwise the first; other arrays
/// are left out. `path` is what messages name. \throw InputError naming the file and line, array or cell,
/// also for volumes other than tetrahedra.
SimplexSoup parse_vtu(std::string_view bytes, const std::filesystem::path& path,
                      const ReadOptions& options = {});

}  // namespace multimesh::io
