// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/texture_child.hpp"

#include <utility>

#include "adapters/openmesh/corner_classes.hpp"
#include "multimesh/build.hpp"
#include "multimesh/openmesh/make_mesh.hpp"

namespace multimesh::openmesh {

namespace {

/// Facets by classes of corners, numbered in order of appearance; `texcoord_of`: per class, into the values.
FacetList by_class(const TexturedCorners& in, Index surface_vertices, std::span<const Vec2> values,
                   std::vector<Index>& texcoord_of) {
  FacetList classes{2, 0, first_equal_corners(in.corners, surface_vertices, in.texcoord, values)};
  for (Index c = 0; c < classes.corners.size(); ++c) {
    Index& first = classes.corners[c];
    if (first != c) {
      first = classes.corners[first];  // before c: already a number
    } else {
      first = classes.vertices++;
      texcoord_of.push_back(in.texcoord[c]);
    }
  }
  return classes;
}

}  // namespace

TextureChild add_texture_child(MultiMesh& tree, NodeId parent, TexturedCorners in,
                               std::span<const Vec2> values) {
  if (in.facets.empty()) throw InputError("no triangle has texture coordinates: the child would be empty");
  const Index surface_vertices = tree.mesh(parent).capacity(0);
  std::vector<Index> texcoord_of;
  Cut texture = cut(by_class(in, surface_vertices, values, texcoord_of));
  in.texcoord = {};
  FacetList over{2, surface_vertices, std::move(in.corners)};
  for (std::size_t f = 0; f < in.facets.size(); ++f)
    if (texture.reversed[f]) std::swap(over.corners[3 * f], over.corners[3 * f + 1]);
  TextureChild child;
  child.texcoord.reserve(texture.source.size());
  for (const Index of_class : texture.source) child.texcoord.push_back(texcoord_of[of_class]);
  child.node =
      add_child_by_facets(tree, parent, std::move(texture.facets), std::move(over), in.facets, make_mesh);
  return child;
}

}  // namespace multimesh::openmesh
