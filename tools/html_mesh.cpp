// SPDX-License-Identifier: BSD-3-Clause
#include "tools/html_mesh.hpp"

#include <array>
#include <map>
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

namespace {

/// Distinguishable by eye, for the first few.
constexpr std::array<std::array<float, 3>, 6> colors = {{{0.62F, 0.69F, 0.80F},
                                                         {0.86F, 0.62F, 0.42F},
                                                         {0.55F, 0.73F, 0.52F},
                                                         {0.78F, 0.55F, 0.68F},
                                                         {0.80F, 0.76F, 0.45F},
                                                         {0.48F, 0.73F, 0.73F}}};

/// The points of the triangles of the surface, corner by corner.
void add_triangles(const TetDomain& domain, NodeId node, HtmlMesh& page) {
  const Mesh& surface = domain.tree().mesh(node);
  const Mesh& root = domain.tree().mesh(NodeId::root);
  std::vector<std::int32_t> number(root.capacity(0), -1);
  for (Index f = 0; f < surface.capacity(2); ++f) {
    if (!surface.is_live(2, f)) continue;
    Index corners[3];
    root.vertices(domain.tree().to_root(node, surface.dart_of(2, f)), corners);
    auto& triangle = page.surface.triangles.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      std::int32_t& n = number[corners[i]];
      if (n < 0) {
        n = static_cast<std::int32_t>(page.surface.positions.size());
        const auto& p = domain.points()[corners[i]];
        page.surface.positions.push_back({p[0], p[1], p[2]});
      }
      triangle[i].position = n;
    }
  }
}

}  // namespace

HtmlMesh html_mesh(const TetDomain& domain) {
  HtmlMesh page;
  const auto node = domain.surface();
  if (!node) return page;
  add_triangles(domain, *node, page);
  const Mesh& surface = domain.tree().mesh(*node);
  std::map<TetDomain::Tag, Index> number;
  for (Index f = 0; f < surface.capacity(2); ++f) {
    if (!surface.is_live(2, f)) continue;
    const TetDomain::Tag tag = domain.patch(f);
    const auto [at, is_new] = number.try_emplace(tag, static_cast<Index>(page.materials.size()));
    if (is_new)
      page.materials.push_back({"patch " + std::to_string(tag), colors[at->second % colors.size()]});
    page.material.push_back(at->second);
  }
  return page;
}

}  // namespace multimesh::tools
