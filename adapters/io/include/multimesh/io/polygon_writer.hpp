// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

/// Writes a surface in the format that the extension names: .ply (binary, with colours, and with texture
/// coordinates by corner), .off or .stl (binary). The file appears complete or not at all.
/// \return what the format cannot store, in sentences
/// \pre all faces are triangles, and indices are in range. \throw InputError
std::vector<std::string> write_polygons(const std::filesystem::path& path, const PolygonSoup& soup);

}  // namespace multimesh::io
