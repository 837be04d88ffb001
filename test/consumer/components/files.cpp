// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "all_headers.hpp"

bool works() {
  using namespace multimesh;
  TexturedTriangles one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles.push_back({{{0, -1}, {1, -1}, {2, -1}}});
  const auto path = std::filesystem::temp_directory_path() / "multimesh_consumer_files.off";
  files::write_surface(path, one);
  files::SurfaceFile file = files::read_surface(path);
  std::filesystem::remove(path);
  return file.warnings.empty() && files::take_surface(file).live_triangles() == 1;
}
