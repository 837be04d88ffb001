// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mesh_reader.hpp"

#include <string>
#include <system_error>

#include "adapters/io/input_location.hpp"
#include "adapters/io/obj_reader.hpp"
#include "adapters/io/ply_reader.hpp"

namespace multimesh::io {

PolygonSoup read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  std::error_code error;
  const bool is_file = std::filesystem::is_regular_file(path, error);
  // What is no file is refused as such by any reader, whatever its extension.
  if (extension == ".obj" || !is_file) return read_obj(path, options);
  if (extension == ".ply") return read_ply(path, options);
  fail_file(path.string(), extension.empty() ? "the file has no extension; .obj and .ply files are read"
                                             : "files with extension " + extension +
                                                   " are not read; convert the mesh to .obj or .ply");
}

}  // namespace multimesh::io
