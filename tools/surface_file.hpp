// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "adapters/io/polygon_soup.hpp"
#include "adapters/io/triangulate.hpp"
#include "multimesh/algorithms/textured_surface.hpp"

namespace multimesh::tools {

/// A textured surface and the file it came from.
struct SurfaceFile {
  std::filesystem::path path;
  io::PolygonSoup soup;
  io::TriangleSoup triangles;
  TexturedTriangles input;
  std::vector<std::string> warnings;
};

/// Reads and triangulates. Polygons with texture coordinates on some corners only lose them; triangles that
/// name a vertex twice are left out; both with a warning. \throw InputError
SurfaceFile read_surface(const std::filesystem::path& path);

/// Writes the surface as it is now, with the file's materials, groups and objects face by face; material
/// libraries are copied next to an output in another directory. \throw InputError
void write_surface(const std::filesystem::path& path, const TexturedSurface& surface, const SurfaceFile& file,
                   std::vector<std::string>& warnings);

}  // namespace multimesh::tools
