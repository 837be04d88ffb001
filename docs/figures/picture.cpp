// SPDX-License-Identifier: BSD-3-Clause
#include "picture.hpp"

#include <algorithm>
#include <cmath>

namespace multimesh::figures {

Vec3 turned(const Vec3& p, double around, double towards) {
  const double x = std::cos(around) * p[0] + std::sin(around) * p[2];
  const double z = -std::sin(around) * p[0] + std::cos(around) * p[2];
  return {x, std::cos(towards) * p[1] - std::sin(towards) * z,
          std::sin(towards) * p[1] + std::cos(towards) * z};
}

DartBuffer triangles_of(const Mesh& mesh) {
  DartBuffer all;
  for (Index f = 0; f < mesh.capacity(2); ++f)
    if (mesh.is_live(2, f)) all.push_back(mesh.dart_of(2, f));
  return all;
}

std::array<Index, 4> vertices_of(const Mesh& mesh, Dart d) {
  std::array<Index, 4> v{};
  mesh.vertices(d, v.data());
  return v;
}

std::vector<std::size_t> charts(const Mesh& texture) {
  constexpr std::size_t none = ~std::size_t{0};
  std::vector<std::size_t> chart(texture.capacity(2), none);
  std::size_t n = 0;
  for (const Dart first : triangles_of(texture)) {
    if (chart[texture.facet(first)] != none) continue;
    DartBuffer waiting{first};
    chart[texture.facet(first)] = n;
    while (!waiting.empty()) {
      const Dart t = waiting.back();
      waiting.pop_back();
      for (const Permutation side : {Permutation{}, edge_ax, edge_bx}) {
        const Dart beyond = texture.switch_dart(texture.reorder(t, side), 2);
        if (beyond == no_dart || chart[texture.facet(beyond)] != none) continue;
        chart[texture.facet(beyond)] = n;
        waiting.push_back(beyond);
      }
    }
    ++n;
  }
  return chart;
}

void draw_surface(Svg& svg, const TexturedSurface& surface, Vec2 corner, Vec2 size,
                  const std::function<std::string(Index)>& fill, double around, double towards) {
  const Mesh& root = surface.tree().mesh(NodeId::root);
  std::vector<Vec3> at;
  std::vector<Vec2> flat;
  for (const Vec3& p : surface.positions()) {
    at.push_back(turned(p, around, towards));
    flat.emplace_back(at.back()[0], at.back()[1]);
  }
  const Fit fit(flat, corner, size);
  DartBuffer front;
  const auto depth = [&](Dart t) {
    const auto v = vertices_of(root, t);
    return at[v[0]][2] + at[v[1]][2] + at[v[2]][2];
  };
  for (const Dart t : triangles_of(root)) {
    const auto v = vertices_of(root, t);
    if (cross(at[v[1]] - at[v[0]], at[v[2]] - at[v[0]])[2] > 0) front.push_back(t);
  }
  std::stable_sort(front.begin(), front.end(), [&](Dart x, Dart y) { return depth(x) < depth(y); });
  for (const Dart t : front) {
    const auto v = vertices_of(root, t);
    svg.polygon({fit(flat[v[0]]), fit(flat[v[1]]), fit(flat[v[2]])}, fill(root.facet(t)));
    for (const Permutation side : {Permutation{}, edge_ax, edge_bx}) {
      const Dart e = root.reorder(t, side);
      const auto w = vertices_of(root, e);
      if (surface.seams() && (surface.curve_kinds(e) & seam_curve) != 0)
        svg.line(fit(flat[w[0]]), fit(flat[w[1]]), "#c00", 1.2);
    }
  }
}

void draw_texture(Svg& svg, const TexturedSurface& surface, Vec2 corner, Vec2 size,
                  const std::function<std::string(Index)>& fill) {
  const Mesh& texture = surface.tree().mesh(*surface.texture());
  const std::vector<Vec2>& at = surface.texcoords();
  const Fit fit(at, corner, size);
  const DartBuffer all = triangles_of(texture);
  for (const Dart t : all) {
    const auto v = vertices_of(texture, t);
    svg.polygon({fit(at[v[0]]), fit(at[v[1]]), fit(at[v[2]])}, fill(texture.facet(t)));
  }
  for (const Dart t : all)
    for (const Permutation side : {Permutation{}, edge_ax, edge_bx}) {
      const Dart e = texture.reorder(t, side);
      const auto w = vertices_of(texture, e);
      if (texture.is_boundary(e, 1)) svg.line(fit(at[w[0]]), fit(at[w[1]]), "#c00", 1.2);
    }
}

}  // namespace multimesh::figures
