// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace multimesh::io {

/// Contents of a file that the soup does not have, and things that looked wrong but were harmless; counts.
struct SoupNotes {
  std::size_t points = 0;             ///< `p` statements, left out
  std::size_t lines = 0;              ///< `l` statements, left out unless ReadOptions::keep_lines
  std::size_t curves = 0;             ///< free-form curves and surfaces, and display attributes, left out
  std::size_t unknown = 0;            ///< unknown statements, elements or properties, left out
  std::size_t weights = 0;            ///< fourth coordinate of a position or alpha of a colour, left out
  std::size_t third_texcoords = 0;    ///< third texture coordinates other than 0, left out
  std::size_t missing_colors = 0;     ///< positions without a colour in a file with colours; white now
  std::size_t missing_texcoords = 0;  ///< corners that named a texture coordinate beyond the last; -1 now
  std::size_t missing_normals = 0;    ///< corners that named a normal beyond the last; -1 now
  std::size_t repeated_corners = 0;   ///< corners equal to the corner before them, left out
  std::size_t collapsed_faces = 0;    ///< faces with fewer than three distinct vertices, left out
  std::size_t flat_faces = 0;         ///< faces without area, kept
  /// Faces with the vertices of an earlier one in any order, with its texture and material, left out unless
  /// ReadOptions::keep_repeated.
  std::size_t repeated_faces = 0;
  std::size_t overlaid_faces = 0;       ///< faces with the vertices of an earlier one that are kept
  std::size_t nonfinite_positions = 0;  ///< with a nan or inf, named by no face or line; ignored
  std::size_t nonfinite_texcoords = 0;  ///< corners that named one with a nan or inf; -1 now
  std::size_t nonfinite_colors = 0;     ///< with a nan or inf; white now
  std::size_t nonfinite_normals = 0;    ///< normals with a nan or inf, set to 0 0 0
  std::size_t merged_positions = 0;     ///< corners of STL facets that were joined with an equal one
  friend bool operator==(const SoupNotes&, const SoupNotes&) = default;
};

/// Polygons as a file stores them: shared positions, texture coordinates and normals, and corners that index
/// the three independently. No connectivity, any topology. All formats are read into this.
struct PolygonSoup {
  /// Indices into positions, texcoords, normals, counted from 0; -1 = the corner has none.
  struct Corner {
    std::int32_t v = -1;
    std::int32_t vt = -1;
    std::int32_t vn = -1;
    friend bool operator==(const Corner&, const Corner&) = default;
  };

  /// The state of the file's grouping statements at a face; an empty string = not set.
  struct Section {
    std::string object;
    std::string group;  ///< all names of the statement
    std::string material;
    std::string smoothing;  ///< empty = off
    friend auto operator<=>(const Section&, const Section&) = default;
  };

  /// A material that the file itself describes, not a library.
  struct Material {
    std::string name;
    std::string texture;  ///< image, as written in the file; empty: none
  };

  std::vector<std::array<double, 3>> positions;
  std::vector<std::array<double, 2>> texcoords;
  std::vector<std::array<double, 3>> normals;
  std::vector<std::array<double, 3>> colors;  ///< red, green, blue in [0, 1] per position, or empty

  std::vector<Corner> corners;
  std::vector<std::uint32_t> face_begin = {0};  ///< \#F+1 offsets into corners
  std::vector<std::uint32_t> face_line;         ///< line of the file, counted from 1; 0 = none (binary)

  std::vector<Section> sections;
  std::vector<std::uint32_t> face_section;  ///< \#F indices into sections

  std::vector<std::int32_t> line_corners;  ///< indices into positions of all polylines, one after the other
  std::vector<std::uint32_t> line_begin = {0};  ///< \#L+1 offsets into line_corners

  std::vector<std::string> material_libraries;  ///< as written in the file, each once
  std::vector<Material> materials;              ///< that faces name by a number
  SoupNotes notes;
  std::vector<std::string> warnings;  ///< one sentence each, naming file and line or element

  std::size_t face_count() const { return face_begin.size() - 1; }

  std::size_t line_count() const { return line_begin.size() - 1; }

  /// \pre i < face_count(). Valid until corners changes.
  std::span<const Corner> face(std::size_t i) const {
    return std::span(corners).subspan(face_begin[i], face_begin[i + 1] - face_begin[i]);
  }
};

}  // namespace multimesh::io
