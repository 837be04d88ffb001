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

/// What is in a file, counted.
struct FileContents {
  std::size_t positions = 0, texcoords = 0, normals = 0, colors = 0;
  std::size_t faces = 0, quads = 0, larger_polygons = 0;  ///< without those that were left out
  std::size_t repeated_faces = 0, collapsed_faces = 0;    ///< left out
  std::size_t polylines = 0;
  std::size_t triangles = 0;                         ///< that were made of them
  std::set<std::string> materials, groups, objects;  ///< names that faces have
};

struct SurfaceReadOptions {
  io::SurfaceWeldOptions weld = {};
  bool follow_paths = false;  ///< read materials and textures outside of the directory of the file, too
};

/// A textured surface as plain lists, and what of its file is needed to write it again. Warnings name the
/// options of the `multimesh` program; SurfaceReadOptions has them all.
struct SurfaceFile {
  std::filesystem::path path;
  TexturedTriangles input;
  FileContents contents;
  std::vector<io::PolygonSoup::Section> sections;  ///< material, group and object; one at least
  std::vector<std::uint32_t> section;              ///< per input triangle; empty: the first for all
  std::vector<std::string> material_libraries;
  std::vector<io::PolygonSoup::Material> materials;  ///< that the file describes itself
  bool follow_paths = false;                         ///< as in SurfaceReadOptions
  std::vector<std::string> warnings;
  io::SurfaceWeldReport weld;

  const io::PolygonSoup::Section& section_of(Index triangle) const {
    return sections[section.empty() ? 0 : section[triangle]];
  }
};

/// The faces of a file of any format, with the polylines if asked for; those of a format with tags in a group
/// for each tag. \throw InputError, also for a file with tetrahedra
io::PolygonSoup read_polygons(const std::filesystem::path& path, bool keep_lines = false);

/// The triangles and edges, copied; a group for each tag. \throw InputError if there are none or too many
io::PolygonSoup polygons_of(const DomainFile& file);

/// Joins vertices at one place, and triangulates. Polygons with texture coordinates on some corners only lose
/// them; triangles that name a vertex twice are left out; both with a warning. \throw InputError if no
/// triangle is left
SurfaceFile to_surface(io::PolygonSoup soup, const std::filesystem::path& path,
                       const SurfaceReadOptions& options = {});

/// Both. \throw InputError
SurfaceFile read_surface(const std::filesystem::path& path, const SurfaceReadOptions& options = {});

/// The tree of the file's triangles, turned round where they do not agree with their neighbours (with a
/// warning), which are given back to the system: `input` is empty then. \throw InputError
TexturedSurface take_surface(SurfaceFile& file, const TexturedSurfaceOptions& options = {});

/// Writes the surface as it is now to an OBJ, PLY, OFF or STL file, with the materials, groups and objects of
/// the file that it came from, face by face; material libraries are copied next to an output in another
/// directory. Normals are computed anew if the file had some. Vertices are apart along seams and hard edges
/// if they were so in the file. \return sentences on what the format has no room for, and on materials and
/// textures that are missing. \throw InputError
std::vector<std::string> write_surface(const std::filesystem::path& path, const TexturedSurface& surface,
                                       const SurfaceFile& file);
/// Plain lists as they are, without materials and normals.
std::vector<std::string> write_surface(const std::filesystem::path& path, const TexturedTriangles& surface);

}  // namespace multimesh::files
