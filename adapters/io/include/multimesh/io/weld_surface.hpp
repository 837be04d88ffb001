// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

/// How to join vertices of a surface whose file has several at one place: exporters write one per texture
/// coordinate, per normal or per corner.
struct SurfaceWeldOptions {
  bool positions = true;  ///< join vertices
  /// Distance, in the units of the file, up to which they count as one place; 0 = equal coordinates.
  double tolerance = 0;
  /// Distance up to which texture coordinates at one vertex are one; relative to their size where that is
  /// above 1. The default covers single-precision rounding of equal ones, some units in the last place.
  double texcoord_tolerance = 2.4e-7;
};

/// What was joined, and what else was found; counts.
struct SurfaceWeldReport {
  std::size_t coincident = 0;      ///< vertices at the place of an earlier one
  std::size_t welded = 0;          ///< of these, joined with an earlier one
  std::size_t redundant = 0;       ///< of these, equal to that one in texture coordinate, normal and colour
  std::size_t copied_faces = 0;    ///< at the place of an earlier face and equal in everything; left out
  std::size_t blended_colors = 0;  ///< vertices joined with one of another colour; they have the mean now
  std::size_t texcoords = 0;       ///< corners whose texture coordinate was joined with a nearly equal one
  std::size_t textured_vertices = 0;  ///< with a texture coordinate
  std::size_t near_texcoords =
      0;  ///< vertices with texture coordinates that are nearly equal, but not joined
  double near_texcoord_distance = 0;  ///< the largest of these
  /// No vertex of the file had several texture coordinates (normals), so the file has several vertices along
  /// seams (hard edges).
  bool split_by_texcoord = false, split_by_normal = false;
  /// At every corner, the index of the texture coordinate (normal) was also that of the vertex.
  bool texcoords_by_vertex = false, normals_by_vertex = false;
};

/// Joins vertices at one place where a surface is open, that is, at the ends of edges with one face. Vertices
/// whose faces form a closed fan stay separate, so that closed parts which touch stay separate; so do the two
/// sides of a sheet that is listed once for each side: the same faces at the same places but with another
/// orientation, material or texture. The result may be non-manifold; the code that makes a mesh of it cuts
/// it. Faces that equal an earlier one in everything are left out; so are those that collapse when vertices
/// are joined, with a warning that names `file`. Then joins nearly equal texture coordinates at a vertex,
/// unless a face would flip in the texture. Vertices that are no longer used stay in the list. Cost: sorting.
/// \pre checked: see check_soup
SurfaceWeldReport weld_surface(PolygonSoup& soup, const SurfaceWeldOptions& options, std::string_view file);

}  // namespace multimesh::io
