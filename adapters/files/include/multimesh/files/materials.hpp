// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "multimesh/files/surface_file.hpp"

namespace multimesh::files {

/// The displayed part of a material.
struct Material {
  std::string name;
  std::array<float, 3> color = {0.8F, 0.8F, 0.8F};  ///< Kd: red, green, blue in [0, 1]
  std::filesystem::path texture = {};               ///< map_Kd, resolved; empty: none
};

/// All materials of the libraries of an OBJ file, the first of each name. Libraries and textures are found as
/// in relocate_material_libraries; those outside the directory of the file are used only with `follow_paths`.
/// \param notes gets one sentence per library or texture that is not used, and one per library about missing
/// textures.
std::vector<Material> read_materials(const std::vector<std::string>& libraries,
                                     const std::filesystem::path& obj, std::vector<std::string>& notes,
                                     bool follow_paths = false);

/// The same for MTL text that is part of a file.
void read_materials(const std::string& mtl, const std::filesystem::path& file,
                    std::vector<Material>& materials, std::vector<std::string>& notes, bool follow_paths);

/// The materials that triangles use.
struct MaterialsInUse {
  std::vector<Material> materials;
  std::vector<Index> of_triangle;  ///< into materials
  std::vector<std::string> notes;  ///< sentences on what was not found or is not used
};

/// The materials of the triangles of a file, or of triangles made from them: `source` has the input triangle
/// from which each one comes, as returned by TexturedSurface::triangles().
MaterialsInUse materials_in_use(const SurfaceFile& file, const std::vector<Index>& source);

}  // namespace multimesh::files
