// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

/// The `mtllib` names for an OBJ file written to `output` whose materials came from `input`.
///
/// Same directory: the names as they are. Another directory: each MTL file is copied next to the output
/// (complete or not at all) with its texture paths rewritten relative to the output, so that they still lead
/// to the same images; images are not copied. A copy has the name of its source; if a different file with
/// that name exists it is left alone, and the copy is named after the output (`out.mtl`, `out_2.mtl`, …). A
/// file equal to the copy is used as it is. MTL files of the input are never written.
///
/// A library is copied if it is an MTL file and find_file() finds it in or below the input's directory, or
/// anywhere if `follow_paths`; lines that are not MTL are left out. Others keep their names.
/// \param libraries PolygonSoup::material_libraries of the input, relative to the input's directory.
/// \param warnings gets one sentence per file that is not copied, or under another name, and per library one
///   about textures that are missing.
/// \throw InputError when an MTL file cannot be written, or the output directory does not exist.
std::vector<std::string> relocate_material_libraries(const std::vector<std::string>& libraries,
                                                     const std::filesystem::path& input,
                                                     const std::filesystem::path& output,
                                                     std::vector<std::string>& warnings,
                                                     bool follow_paths = false);

/// MTL text for materials that a file itself describes.
std::string mtl_text(const std::vector<PolygonSoup::Material>& materials);

/// Writes them to a library beside an OBJ file that is written to `output`, named after it, in the same way
/// as the copies of relocate_material_libraries(). \return its name. \throw InputError
std::string write_material_library(const std::vector<PolygonSoup::Material>& materials,
                                   const std::filesystem::path& input, const std::filesystem::path& output,
                                   std::vector<std::string>& warnings);

}  // namespace multimesh::io
