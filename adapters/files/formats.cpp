// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/files/formats.hpp"

#include <string>

#include "adapters/io/gunzip.hpp"

namespace multimesh::files {

bool is_surface_format(const std::filesystem::path& path) {
  const std::string extension = io::format_extension(path);
  return extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".off";
}

}  // namespace multimesh::files
