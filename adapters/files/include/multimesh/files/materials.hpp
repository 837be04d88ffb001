// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "multimesh/files/surface_file.hpp"

namespace multimesh::files {

/// What is shown of a material.
struct Material {
  std::string name;
  std::array<float, 3> color = {0.8F, 0.8F, 0.8F};  ///< Kd: red, green, blue in [0, 1]
  std::filesystem::path texture = {};               ///< map_Kd, resolved; empty: none
};

/// All materials of the libraries of an OBJ file, the first of each name. Libraries and textures are found as
/// relocate_material_libraries has it; those outside of the directory of the file are used only if paths are
/// followed. \param notes gets a sentence per library or texture that is not used, and one per library about
/// textures that are missing.
std::vector<Material> read_materials(const std::vector<std::string>& libraries,
                                     const std::filesystem::path& obj, std::vector<std::string>& notes,
                                     bool follow_paths = false);

/// The same of MTL text that belongs to a file itself.
void read_materials(const std::string& mtl, const std::filesystem::path& file,
                    std::vector<Material>& materials, std::vector<std::string>& notes, bool follow_paths);

/// The materials that triangles have.
struct MaterialsInUse {
  std::vector<Material> materials;
  std::vector<Index> of_triangle;  ///< into materials
  std::vector<std::string> notes;  ///< sentences on what was not found or is not used
};

/// Of the triangles of a file, or of what was made of them: `source` has the triangle of the input that each
/// one comes from, as TexturedSurface::triangles() gives it.
MaterialsInUse materials_in_use(const SurfaceFile& file, const std::vector<Index>& source);

}  // namespace multimesh::files
