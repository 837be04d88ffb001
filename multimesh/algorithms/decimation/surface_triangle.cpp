// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/decimation/surface_triangle.hpp"

#include <algorithm>
#include <string>

namespace multimesh::decimation {

TriangleReader::TriangleReader(const TexturedSurface& surface, const Strata& strata)
    : strata_(strata), root_(surface.tree().mesh(NodeId::root)), positions_(surface.positions()) {
  for (const NodeId n : surface.textures())
    textures_.push_back(
        {FacetCopies(surface.tree(), n), &surface.tree().mesh(n), &surface.texcoords(textures_.size())});
  if (textures_.size() > max_sets)
    throw InputError("decimate: " + std::to_string(textures_.size()) + " UV sets; at most " +
                     std::to_string(max_sets) + " are supported");
}

void TriangleReader::read(Dart d, SurfaceTriangle& t) const {
  std::array<Index, 4> v;
  root_.vertices(d, v.data());
  t.facet = root_.facet(d);
  for (std::size_t i = 0; i < 3; ++i) {
    t.vertices[i] = v[i];
    t.positions[i] = positions_[v[i]];
  }
  std::array<Dart, max_sets> copies;
  for (std::size_t k = 0; k < n_sets(); ++k) {
    SurfaceTriangle::Textured& set = t.sets[k];
    const auto& [facet_over, texture, texcoords] = textures_[k];
    copies[k] = facet_over(d);
    set.facet = no_index;
    if (copies[k] == no_dart) continue;
    set.facet = texture->facet(copies[k]);
    texture->vertices(copies[k], v.data());
    for (std::size_t i = 0; i < 3; ++i) {
      set.vertices[i] = v[i];
      set.texcoords[i] = (*texcoords)[v[i]];
    }
  }
  read_curves(d, copies, t);
}

// Most triangles have at most one vertex on a curve, and so no edge.
void TriangleReader::read_curves(Dart d, const std::array<Dart, max_sets>& copies, SurfaceTriangle& t) const {
  t.has_curves = false;
  const auto bound = [&](std::size_t i) { return strata_.rank(t.vertices[i]) != Rank::free; };
  if (bound(0) + bound(1) + bound(2) < 2) return;
  static constexpr std::array<Permutation, 3> edges{Permutation{}, edge_bx, permutation(2, 0, 1)};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool candidate = bound(i) && bound((i + 1) % 3);
    t.curve_weights[i] = candidate ? strata_.weight(root_.reorder(d, edges[i])) : 0;
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
