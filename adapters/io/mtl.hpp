// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace multimesh::io {

/// The `mtllib` names for an OBJ file written to `output` whose materials came with `input`.
///
/// Same directory: the names as they are. Another directory: each MTL file is copied next to the output
/// (complete or not at all) with its texture paths rewritten relative to the output, so that they still lead
/// to the same images; no image is copied. A copy takes the name of its source; if a different file has that
/// name already it is left alone, and the copy is named after the output (`out.mtl`, `out_2.mtl`, …). A file
/// equal to the copy is used as it is. MTL files of the input are never written to.
///
/// A missing MTL file keeps its name and adds a warning.
/// \param libraries PolygonSoup::material_libraries of the input, relative to the input's directory.
/// \param warnings gets one sentence per missing file and per copy under another name.
/// \throw InputError when an MTL file cannot be read or written, or the output directory does not exist.
std::vector<std::string> relocate_material_libraries(const std::vector<std::string>& libraries,
                                                     const std::filesystem::path& input,
                                                     const std::filesystem::path& output,
                                                     std::vector<std::string>& warnings);

}  // namespace multimesh::io
