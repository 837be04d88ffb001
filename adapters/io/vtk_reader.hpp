// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Parses an unstructured grid or poly data in VTK's legacy format (.vtk), text or binary, with cells as
/// before version 5 or since. The tag is chosen as in parse_vtu, among scalars and fields of cells. Messages
/// name `path`. \throw InputError naming the file and line, byte or cell, also for volumes other than
/// tetrahedra.
SimplexSoup parse_vtk(std::string_view bytes, const std::filesystem::path& path,
                      const ReadOptions& options = {});

}  // namespace multimesh::io
