// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "multimesh/io/polygon_soup.hpp"
#include "multimesh/io/read_options.hpp"
#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// The positions, the polygons cut into triangles (see triangulate), and the polylines as edges, with tag 0.
/// Triangles have one tag per object and group of the file, counted from 1, with its name; 0 where it has
/// none. Texture coordinates, normals and colours are left out. Warnings are copied. Messages name `path`.
/// \throw InputError as SimplexBuilder::finish
SimplexSoup to_simplices(PolygonSoup polygons, const std::filesystem::path& path,
                         const ReadOptions& options = {});

/// The triangles and edges of a soup as faces and polylines of two vertices, without their tags.
/// \pre indices fit into 31 bits
PolygonSoup to_polygons(const SimplexSoup& soup);

/// The same with one section per tag of triangles; its group is the names of its groups, or their
/// tags.
PolygonSoup to_grouped_polygons(const SimplexSoup& soup);

}  // namespace multimesh::io
