// SPDX-License-Identifier: BSD-3-Clause
#include "tools/html_mesh.hpp"

#include <numeric>

namespace multimesh::tools {

HtmlMesh html_mesh(TexturedTriangles surface, const std::vector<Index>& source,
                   const files::SurfaceFile& file) {
  files::MaterialsInUse in_use = files::materials_in_use(file, source);
  return {.caption = file.path.filename().string(),
          .surface = std::move(surface),
          .materials = std::move(in_use.materials),
          .material = std::move(in_use.of_triangle),
          .notes = std::move(in_use.notes)};
}

HtmlMesh html_mesh(const files::SurfaceFile& file) {
  std::vector<Index> all(file.input.triangles.size());
  std::iota(all.begin(), all.end(), Index{0});
  return html_mesh(file.input, all, file);
}

}  // namespace multimesh::tools
