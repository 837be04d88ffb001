// SPDX-License-Identifier: BSD-3-Clause
// The surface and its textures, from triangles.
#include <algorithm>
#include <string>
#include <utility>

#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/domains/shading.hpp"
#include "multimesh/domains/textured_surface/data.hpp"
#include "multimesh/openmesh/texture_child.hpp"

namespace multimesh {

namespace {

FacetList by_position(const TexturedTriangles& input) {
  FacetList facets{2, static_cast<Index>(input.positions.size()), {}};
  facets.corners.reserve(3 * input.triangles.size());
  for (const auto& t : input.triangles)
    for (const auto& c : t) facets.corners.push_back(static_cast<Index>(c.position));
  return facets;
}

/// The corner of the input triangle that is corner i of a facet: the cut exchanges the first two.
std::size_t input_corner(const Cut& cut, Index facet, std::size_t i) {
  return cut.reversed[facet] && i < 2 ? 1 - i : i;
}

void lock_copies(std::size_t positions, TexturedSurface::Data& out) {
  out.is_copy = out.add_values<char>(NodeId::root, 0, "copy");
  std::vector<Index> copies(positions, 0);
  for (const Index v : *out.source_position) ++copies[v];
  Mesh& root = out.tree->mesh(NodeId::root);
  for (Index v = 0; v < out.source_position->size(); ++v) {
    const bool copied = copies[(*out.source_position)[v]] > 1;
    (*out.is_copy)[v] = copied;
    if (copied) root.set_locked(v, true);
  }
  for (const Index n : copies) out.report.copied_vertices += n > 1 ? n - 1 : 0;
}

void add_colors(const TexturedTriangles& input, TexturedSurface::Data& out) {
  if (input.colors.empty()) return;
  out.colors = out.add_values<Vec3>(NodeId::root, 0, "color");
  for (Index v = 0; v < out.colors->size(); ++v) (*out.colors)[v] = input.colors[(*out.source_position)[v]];
}

/// The edge of a facet that is opposite to its corner i in the cut's order.
Index opposite_edge(const Mesh& root, const Cut& cut, Index f, std::size_t i) {
  Dart d = root.dart_of(2, f);
  for (std::array<Index, 4> v{};; d = root.switch_dart(root.switch_dart(d, 0), 1)) {
    root.vertices(d, v.data());
    if (v[2] == cut.facets.facet(f)[i]) return root.simplex(d, 1);
  }
}

void add_shading(const TexturedTriangles& input, const Cut& cut, TexturedSurface::Data& out) {
  if (input.shading.empty()) return;
  out.hard = out.add_values<char>(NodeId::root, 1, "mm:hard");
  out.triangle_shading = out.add_values<char>(NodeId::root, 2, "shading");
  const Mesh& root = out.tree->mesh(NodeId::root);
  for (Index f = 0; f < input.shading.size(); ++f) {
    const unsigned bits = input.shading[f];
    (*out.triangle_shading)[f] = static_cast<char>(bits & (normals_behind | flat_shaded));
    if ((bits & hard_edges) == 0) continue;
    for (std::size_t i = 0; i < 3; ++i)  // the edge opposite to corner i begins at the corner after it
      if ((bits >> (input_corner(cut, f, i) + 1) % 3 & 1U) != 0)
        (*out.hard)[opposite_edge(root, cut, f, i)] = 1;
  }
}

/// The triangles with texture coordinates in one set, corner by corner, by vertices of the surface.
openmesh::TexturedCorners textured_part(const TexturedTriangles& input, const Cut& cut, std::size_t set) {
  openmesh::TexturedCorners part;
  part.corners.reserve(cut.facets.corners.size());
  part.texcoord.reserve(cut.facets.corners.size());
  part.facets.reserve(input.triangles.size());
  for (Index f = 0; f < input.triangles.size(); ++f) {
    if (input.texcoord(set, f, 0) < 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      part.corners.push_back(cut.facets.facet(f)[i]);
      part.texcoord.push_back(static_cast<Index>(input.texcoord(set, f, input_corner(cut, f, i))));
    }
    part.facets.push_back(f);
  }
  return part;
}

}  // namespace

Cut add_surface(const TexturedTriangles& input, TexturedSurface::Data& out) {
  Cut cut = multimesh::cut(by_position(input));
  out.tree = std::make_unique<MultiMesh>(make_mesh(cut.facets));
  out.positions = out.add_values<Vec3>(NodeId::root, 0, "position");
  out.source_position = out.add_values<Index>(NodeId::root, 0, "source position");
  out.source_triangle = out.add_values<Index>(NodeId::root, 2, "source triangle");
  out.reversed = out.add_values<char>(NodeId::root, 2, "reversed");
  for (Index v = 0; v < cut.source.size(); ++v) {
    (*out.positions)[v] = input.positions[cut.source[v]];
    (*out.source_position)[v] = cut.source[v];
  }
  for (Index f = 0; f < input.triangles.size(); ++f) {
    (*out.source_triangle)[f] = f;
    (*out.reversed)[f] = cut.reversed[f];
    out.report.reversed_triangles += cut.reversed[f];
  }
  lock_copies(input.positions.size(), out);
  add_colors(input, out);
  add_shading(input, cut, out);
  return cut;
}

void add_texture(const TexturedTriangles& input, const Cut& surface, std::size_t set,
                 TexturedSurface::Data& out) {
  openmesh::TexturedCorners part = textured_part(input, surface, set);
  if (set == 0) out.report.triangles_without_texcoords = input.triangles.size() - part.facets.size();
  if (part.facets.empty() && input.uv_sets() == 1) return;
  if (part.facets.empty())
    throw InputError("set " + std::to_string(set) +
                     " of texture coordinates is used by no triangle; leave it out");
  const auto child =
      openmesh::add_texture_child(*out.tree, NodeId::root, std::move(part), input.texcoords_of(set));
  out.textures.push_back(child.node);
  out.texcoords.push_back(out.add_values<Vec2>(child.node, 0, "texcoord"));
  for (Index v = 0; v < child.texcoord.size(); ++v)
    (*out.texcoords.back())[v] = input.texcoords_of(set)[child.texcoord[v]];
}

}  // namespace multimesh
