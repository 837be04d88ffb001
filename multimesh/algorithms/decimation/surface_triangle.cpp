// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/surface_triangle.hpp"

#include <algorithm>
#include <string>

#include "multimesh/geometry/bounding_box.hpp"

namespace multimesh::decimation {

namespace {

double diagonal_of(const Mesh& mesh, const std::vector<Vec3>& positions) {
  std::vector<Vec3> used;
  for (Index v = 0; v < mesh.capacity(0); ++v)
    if (mesh.is_live(0, v) && mesh.dart_of(0, v) != no_dart) used.push_back(positions[v]);
  return bounding_box_diagonal(used);
}

}  // namespace

TriangleReader::TriangleReader(EmbeddedMesh& surface, const Ranks& ranks)
    : surface_(surface),
      ranks_(ranks),
      mesh_(surface.mesh()),
      list_(surface.positions(), surface.mesh(), surface.operations()),
      positions_(list_.values()),
      diagonal_(diagonal_of(mesh_, positions_)) {
  if (surface.charts().size() > max_sets)
    throw InputError("decimate: " + std::to_string(surface.charts().size()) + " UV sets; at most " +
                     std::to_string(max_sets) + " are supported");
  for (Coordinates* const chart : surface.charts()) add_texture(*chart);
}

void TriangleReader::add_texture(Coordinates& chart) {
  const MultiMesh& tree = surface_.tree();
  std::vector<FacetCopies> down;
  for (NodeId n = chart.node(); n != surface_.node(); n = tree.parent(n)) down.emplace_back(tree, n);
  std::reverse(down.begin(), down.end());
  const Mesh& mesh = tree.mesh(chart.node());
  auto list = std::make_unique<CoordinateList<Vec2>>(chart, mesh, surface_.operations());
  const std::vector<Vec2>& texcoords = list->values();
  textures_.push_back({chart.node(), &mesh, std::move(down), std::move(list), &texcoords});
}

inline Dart TriangleReader::Texture::facet_over(Dart d) const {
  for (const FacetCopies& step : down) {
    d = step(d);
    if (d == no_dart) break;
  }
  return d;
}

std::array<Vec3, 3> TriangleReader::positions(Dart d) const {
  std::array<Index, 4> v;
  mesh_.vertices(d, v.data());
  return {positions_[v[0]], positions_[v[1]], positions_[v[2]]};
}

void TriangleReader::read(Dart d, SurfaceTriangle& t) const {
  std::array<Index, 4> v;
  mesh_.vertices(d, v.data());
  t.facet = mesh_.facet(d);
  for (std::size_t i = 0; i < 3; ++i) {
    t.vertices[i] = v[i];
    t.positions[i] = positions_[v[i]];
  }
  std::array<Dart, max_sets> copies;
  for (std::size_t k = 0; k < n_sets(); ++k) {
    SurfaceTriangle::Textured& set = t.sets[k];
    const Texture& texture = textures_[k];
    copies[k] = texture.facet_over(d);
    set.facet = no_index;
    if (copies[k] == no_dart) continue;
    set.facet = texture.mesh->facet(copies[k]);
    texture.mesh->vertices(copies[k], v.data());
    for (std::size_t i = 0; i < 3; ++i) {
      set.vertices[i] = v[i];
      set.texcoords[i] = (*texture.texcoords)[v[i]];
    }
  }
  read_curves(d, copies, t);
}

// Most triangles have at most one vertex on a curve, and so no edge.
void TriangleReader::read_curves(Dart d, const std::array<Dart, max_sets>& copies, SurfaceTriangle& t) const {
  t.has_curves = false;
  const auto bound = [&](std::size_t i) { return ranks_.rank(t.vertices[i]) != Rank::free; };
  if (bound(0) + bound(1) + bound(2) < 2) return;
  static constexpr std::array<Permutation, 3> edges{Permutation{}, edge_bx, permutation(2, 0, 1)};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool candidate = bound(i) && bound((i + 1) % 3);
    t.curve_weights[i] = candidate ? ranks_.weight(mesh_.reorder(d, edges[i])) : 0;
    t.has_curves |= t.curve_weights[i] > 0;
    for (std::size_t k = 0; k < n_sets(); ++k) {
      if (t.sets[k].facet == no_index) continue;
      const Mesh& texture = *textures_[k].mesh;
      t.sets[k].open[i] = candidate && texture.is_boundary(texture.reorder(copies[k], edges[i]), 1);
      t.has_curves |= t.sets[k].open[i];
    }
  }
}

}  // namespace multimesh::decimation
