// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "multimesh/domains/textured_surface.hpp"
#include "multimesh/files/domain_file.hpp"
#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/weld_surface.hpp"

namespace multimesh::files {

/// Counts of what is in a file.
struct FileContents {
  std::size_t positions = 0, texcoords = 0, normals = 0, colors = 0;
  std::size_t faces = 0, quads = 0, larger_polygons = 0;  ///< without those that were left out
  std::size_t repeated_faces = 0, collapsed_faces = 0;    ///< left out
  std::size_t polylines = 0;
  std::size_t triangles = 0;                         ///< made from the faces
  std::set<std::string> materials, groups, objects;  ///< names that faces have
};

struct SurfaceReadOptions {
  io::SurfaceWeldOptions weld = {};
  bool follow_paths = false;  ///< also read materials and textures outside the directory of the file
};

/// A textured surface as plain lists, and the information needed to write its file again. Warnings name the
/// options of the `multimesh` program; SurfaceReadOptions has them all.
struct SurfaceFile {
  std::filesystem::path path;
  TexturedTriangles input;
  FileContents contents;
  std::vector<io::PolygonSoup::Section> sections;  ///< material, group and object; at least one
  std::vector<std::uint32_t> section;              ///< per input triangle; empty: the first for all
  std::vector<std::string> material_libraries;
  std::vector<io::PolygonSoup::Material> materials;  ///< that the file itself describes
  bool follow_paths = false;                         ///< as in SurfaceReadOptions
  std::vector<std::string> warnings;
  io::SurfaceWeldReport weld;

  const io::PolygonSoup::Section& section_of(Index triangle) const {
    return sections[section.empty() ? 0 : section[triangle]];
  }
};

/// Reads the faces of a file of any format, with the polylines if requested; the faces of a format with tags
/// are in one group per tag. \throw InputError, also for a file with tetrahedra
io::PolygonSoup read_polygons(const std::filesystem::path& path, bool keep_lines = false);

/// The triangles and edges, copied; one group per tag. \throw InputError if there are none or too many
io::PolygonSoup polygons_of(const DomainFile& file);

/// Joins vertices at one place, and triangulates. Polygons with texture coordinates on only some corners lose
/// them; triangles that name a vertex twice are left out; both cause a warning. \throw InputError if no
/// triangle is left
SurfaceFile to_surface(io::PolygonSoup soup, const std::filesystem::path& path,
                       const SurfaceReadOptions& options = {});

/// read_polygons(), then to_surface(). \throw InputError
SurfaceFile read_surface(const std::filesystem::path& path, const SurfaceReadOptions& options = {});

/// Builds the tree from the file's triangles. Triangles that do not agree with their neighbours are reversed,
/// with a warning. Frees the triangles of the file: `input` is empty afterwards. \throw InputError
TexturedSurface take_surface(SurfaceFile& file, const TexturedSurfaceOptions& options = {});

/// Writes the current surface to an OBJ, PLY, OFF or STL file, with the materials, groups and objects of its
/// original file, face by face. Material libraries are copied next to an output in another directory. Normals
/// are recomputed if the file had some. Vertices are separate along seams and hard edges if they were in the
/// file. \return sentences on what the format cannot store, and on missing materials and textures.
/// \throw InputError
std::vector<std::string> write_surface(const std::filesystem::path& path, const TexturedSurface& surface,
                                       const SurfaceFile& file);
/// Writes plain lists, without materials and normals.
std::vector<std::string> write_surface(const std::filesystem::path& path, const TexturedTriangles& surface);

}  // namespace multimesh::files
