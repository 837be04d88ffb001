// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/io/mesh_reader.hpp"

#include <array>
#include <string>
#include <system_error>

#include "adapters/io/gunzip.hpp"
#include "adapters/io/input_location.hpp"
#include "adapters/io/off_reader.hpp"
#include "adapters/io/ply_reader.hpp"
#include "adapters/io/stl_reader.hpp"
#include "multimesh/io/obj_reader.hpp"

namespace multimesh::io {
namespace {

bool is_packed(const std::filesystem::path& path) {
  std::array<char, 2> begin{};
  return InputFile(path).read(begin.data(), 2) == 2 && is_gzip({begin.data(), 2});
}

}  // namespace

PolygonSoup read_mesh(const std::filesystem::path& path, const ReadOptions& options) {
  std::error_code error;
  // Whatever its extension, any reader refuses something that is not a file.
  if (!std::filesystem::is_regular_file(path, error)) return read_obj(path, options);
  // Not through memory like the others: OBJ files are the large ones.
  if (format_extension(path) == ".obj" && !is_packed(path)) return read_obj(path, options);
  return parse_mesh(UnpackedBytes(path).view(), path, options);
}

PolygonSoup parse_mesh(std::string_view bytes, const std::filesystem::path& path,
                       const ReadOptions& options) {
  const std::string extension = format_extension(path);
  if (extension == ".obj") return parse_obj(bytes, path, options);
  if (extension == ".ply") return parse_ply(bytes, path, options);
  if (extension == ".stl") return parse_stl(bytes, path, options);
  if (extension == ".off") return parse_off(bytes, path, options);
  fail_file(path.string(), (extension.empty() ? "the file has no extension"
                                              : "files with extension " + extension + " are not read") +
                               "; convert the mesh to .obj, .ply, .stl or .off");
}

}  // namespace multimesh::io
