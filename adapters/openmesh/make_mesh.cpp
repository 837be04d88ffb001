// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/openmesh/make_mesh.hpp"

#include <array>
#include <string>

#include "adapters/openmesh/edge_mesh.hpp"
#include "adapters/openmesh/triangle_mesh.hpp"
#include "multimesh/error.hpp"

namespace multimesh::openmesh {

namespace {

using OpenMesh::PolyConnectivity;
using OpenMesh::VertexHandle;

VertexHandle vertex(Index v) {
  return VertexHandle(static_cast<int>(v));
}

/// OpenMesh reports faces that do not fit on its error stream; libraries print nothing.
class Silence {
 public:
  Silence() : was_enabled_(::omerr().is_enabled()) { ::omerr().disable(); }
  ~Silence() {
    if (was_enabled_) ::omerr().enable();
  }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  bool was_enabled_;
};

std::unique_ptr<PolyConnectivity> make_triangles(const FacetList& list) {
  auto om = std::make_unique<PolyConnectivity>();
  om->reserve(list.vertices, 3 * list.size() / 2 + list.vertices / 8, list.size());
  om->resize(list.vertices, 0, 0);
  const Silence silence;
  for (std::size_t f = 0; f < list.size(); ++f) {
    const auto v = list.facet(f);
    const std::array<VertexHandle, 3> corners{vertex(v[0]), vertex(v[1]), vertex(v[2])};
    if (!om->add_face(corners.data(), 3).is_valid())
      throw InputError("facet " + std::to_string(f) + " does not fit: the mesh is not manifold there");
  }
  return om;
}

// Halfedges are linked along the curve and turn round at its ends.
std::unique_ptr<PolyConnectivity> make_edges(const FacetList& list) {
  auto om = std::make_unique<PolyConnectivity>();
  om->reserve(list.vertices, list.size(), 0);
  om->resize(list.vertices, 0, 0);
  std::vector<std::array<OpenMesh::HalfedgeHandle, 2>> outgoing(list.vertices);
  for (std::size_t f = 0; f < list.size(); ++f) {
    const auto v = list.facet(f);
    const auto h = om->new_edge(vertex(v[0]), vertex(v[1]));
    for (const auto& [w, out] : {std::pair{v[0], h}, std::pair{v[1], om->opposite_halfedge_handle(h)}}) {
      auto& slots = outgoing[w];
      if (slots[1].is_valid())
        throw InputError("edge " + std::to_string(f) + " is the third at vertex " + std::to_string(w) +
                         "; cut the curves there");
      (slots[0].is_valid() ? slots[1] : slots[0]) = out;
    }
  }
  for (Index v = 0; v < list.vertices; ++v) {
    const auto& [first, second] = outgoing[v];
    if (!first.is_valid()) continue;
    om->set_halfedge_handle(vertex(v), first);
    const auto other = second.is_valid() ? second : first;
    om->set_next_halfedge_handle(om->opposite_halfedge_handle(first), other);
    om->set_next_halfedge_handle(om->opposite_halfedge_handle(other), first);
  }
  return om;
}

}  // namespace

std::unique_ptr<Mesh> make_mesh(const FacetList& list) {
  if (list.dimension < 1 || list.dimension > 2)
    throw InputError("OpenMesh holds edge and triangle meshes, not dimension " +
                     std::to_string(list.dimension));
  for (std::size_t c = 0; c < list.corners.size(); ++c)
    if (list.corners[c] >= list.vertices)
      throw InputError("facet " + std::to_string(c / list.corners_per_facet()) + " names vertex " +
                       std::to_string(list.corners[c]) + " of " + std::to_string(list.vertices));
  if (list.dimension == 1) return std::make_unique<EdgeMesh>(make_edges(list));
  return std::make_unique<TriangleMesh>(make_triangles(list));
}

}  // namespace multimesh::openmesh
