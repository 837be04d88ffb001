// SPDX-License-Identifier: BSD-3-Clause
#include "tools/html_mesh.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "adapters/io/mtl.hpp"

namespace multimesh::tools {

HtmlMesh html_mesh(TexturedTriangles surface, const std::vector<Index>& source, const SurfaceFile& file) {
  HtmlMesh mesh{.caption = file.path.filename().string(), .surface = std::move(surface)};
  std::vector<Material> known =
      read_materials(file.material_libraries, file.path, mesh.notes, file.follow_paths);
  read_materials(io::mtl_text(file.materials), file.path, known, mesh.notes, file.follow_paths);
  std::map<std::string, Index> number;
  for (const Index t : source) {
    const std::string& name = file.section_of(t).material;
    const auto [at, is_new] = number.try_emplace(name, static_cast<Index>(mesh.materials.size()));
    mesh.material.push_back(at->second);
    if (!is_new) continue;
    const auto found = std::ranges::find(known, name, &Material::name);
    mesh.materials.push_back(found != known.end() ? *found : Material{.name = name});
    if (found == known.end() && !name.empty() && !known.empty())
      mesh.notes.push_back("material " + name + ": not in the material libraries; it is grey");
  }
  return mesh;
}

HtmlMesh html_mesh(const SurfaceFile& file) {
  std::vector<Index> all(file.input.triangles.size());
  std::iota(all.begin(), all.end(), Index{0});
  return html_mesh(file.input, all, file);
}

}  // namespace multimesh::tools
