// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

struct WriteOptions {
  /// Comment lines at the top of the file, without `# `.
  std::vector<std::string> header = {};
  /// `vn` statements and normal indices; without them viewers compute their own normals.
  bool normals = true;
};

/// Writes a Wavefront OBJ file. Faces keep their order, polylines come last; mtllib comes first, and o, g,
/// usemtl and s where they change from one face to the next. Numbers have the fewest digits that reproduce
/// the same double: read_obj of the result gives equal positions, colours, texcoords, normals, corners and
/// sections per face. The file appears complete or not at all (AtomicFile). \pre all indices of the soup
/// are in range; names have no line ends. \throw InputError for a directory, a missing directory, a full
/// disk.
void write_obj(const std::filesystem::path& path, const PolygonSoup& soup, const WriteOptions& options = {});

}  // namespace multimesh::io
