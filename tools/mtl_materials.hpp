// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace multimesh::tools {

/// What a report shows of a material.
struct Material {
  std::string name;
  std::array<float, 3> color = {0.8F, 0.8F, 0.8F};  ///< Kd: red, green, blue in [0, 1]
  std::filesystem::path texture = {};               ///< map_Kd, resolved; empty: none
};

/// All materials of the libraries of an OBJ file, the first of each name. Libraries are relative to the file;
/// textures lie beside their library, or else beside the OBJ file, and the separators of Windows are
/// understood, as relocate_material_libraries has it. \param notes gets a sentence per library not read.
std::vector<Material> read_materials(const std::vector<std::string>& libraries,
                                     const std::filesystem::path& obj, std::vector<std::string>& notes);

}  // namespace multimesh::tools
