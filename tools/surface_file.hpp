// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "adapters/io/polygon_soup.hpp"
#include "multimesh/algorithms/textured_surface.hpp"

namespace multimesh::tools {

/// What is in a file, counted.
struct FileContents {
  std::size_t positions = 0, texcoords = 0, normals = 0, colors = 0;
  std::size_t faces = 0, quads = 0, larger_polygons = 0;
  std::size_t triangles = 0;                         ///< that were made of them
  std::set<std::string> materials, groups, objects;  ///< names that faces have
};

/// A textured surface, and what of its file is needed to write it again.
struct SurfaceFile {
  std::filesystem::path path;
  TexturedTriangles input;
  FileContents contents;
  std::vector<io::PolygonSoup::Section> sections;  ///< one at least
  std::vector<std::uint32_t> section;              ///< per input triangle; empty: the first for all
  std::vector<std::string> material_libraries;
  std::vector<io::PolygonSoup::Material> materials;  ///< that the file describes itself
  bool follow_paths = false;  ///< read materials and textures outside of the directory of the file, too
  std::vector<std::string> warnings;

  const io::PolygonSoup::Section& section_of(Index triangle) const {
    return sections[section.empty() ? 0 : section[triangle]];
  }
};

/// Reads and triangulates. Polygons with texture coordinates on some corners only lose them; triangles that
/// name a vertex twice are left out; both with a warning. \throw InputError
SurfaceFile read_surface(const std::filesystem::path& path);

/// The tree of the file's triangles, turned round where they do not agree with their neighbours (with a
/// warning), which are given back to the system: `input` is empty then.
TexturedSurface take_surface(SurfaceFile& file, const TexturedSurfaceOptions& options = {});

/// Writes the surface as it is now, with the file's materials, groups and objects face by face; material
/// libraries are copied next to an output in another directory. Normals are computed anew if the file had
/// some. \throw InputError
void write_surface(const std::filesystem::path& path, const TexturedSurface& surface, const SurfaceFile& file,
                   std::vector<std::string>& warnings);

}  // namespace multimesh::tools
