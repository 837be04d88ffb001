// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/make_mesh.hpp"

#include <array>
#include <set>
#include <string>

#include "multimesh/error.hpp"
#include "multimesh/openmesh/edge_mesh.hpp"
#include "multimesh/openmesh/point_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"
#include "multimesh/pair_numbers.hpp"

namespace multimesh::openmesh {

namespace {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::PolyConnectivity;
using OpenMesh::VertexHandle;

VertexHandle vertex(Index v) {
  return VertexHandle(static_cast<int>(v));
}
HalfedgeHandle halfedge(Index h) {
  return HalfedgeHandle(static_cast<int>(h));
}

/// Sets the connectivity of a triangle list word by word. The result is that of OpenMesh's add_face, number
/// by number; add_face takes several times as long in Debian's library.
class TriangleBuilder {
 public:
  explicit TriangleBuilder(const FacetList& list) : list_(list) {}

  std::unique_ptr<PolyConnectivity> run() {
    number_halfedges();
    for (std::size_t f = 0; f < list_.size(); ++f) add(f);
    halfedges_ = {};
    turn_boundary_vertices();
    require_one_fan_each();
    link_boundary();
    return std::move(om_);
  }

 private:
  // Edges are numbered in order of appearance; the even halfedge has the direction of the first triangle.
  void number_halfedges() {
    PairNumbers edges(list_.vertices, list_.corners);
    edges.reserve(list_.corners.size() / 2 + list_.corners.size() / 16);
    halfedges_.resize(list_.corners.size());
    for (std::size_t f = 0; f < list_.size(); ++f) {
      const auto v = list_.facet(f);
      for (std::size_t i = 0; i < 3; ++i) {
        const Index known = edges.size();
        const Index e = edges(v[i], v[(i + 1) % 3]);
        halfedges_[3 * f + i] = 2 * e + (e < known ? 1 : 0);
      }
    }
    om_->resize(list_.vertices, edges.size(), list_.size());
  }

  void add(std::size_t f) {
    const auto v = list_.facet(f);
    const Index* const h = &halfedges_[3 * f];
    if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) fail(f, "it has a vertex twice");
    const FaceHandle face(static_cast<int>(f));
    for (std::size_t i = 0; i < 3; ++i) {
      const HalfedgeHandle side = halfedge(h[i]), back = halfedge(h[i] ^ 1);
      const VertexHandle from = vertex(v[i]), to = vertex(v[(i + 1) % 3]);
      if (om_->face_handle(side).is_valid())
        fail(f, "it is the third at the edge of vertices " + std::to_string(v[i]) + " and " +
                    std::to_string(v[(i + 1) % 3]));
      if (h[i] % 2 == 0) {
        om_->set_vertex_handle(side, to);
        om_->set_vertex_handle(back, from);
      } else if (om_->to_vertex_handle(side) != to) {
        fail(f, "it runs from vertex " + std::to_string(v[i]) + " to " + std::to_string(v[(i + 1) % 3]) +
                    " as its neighbour does");
      }
      om_->set_face_handle(side, face);
      om_->set_next_halfedge_handle(side, halfedge(h[(i + 1) % 3]));
      om_->set_halfedge_handle(from, side);
    }
    om_->set_halfedge_handle(face, halfedge(h[2]));
  }

  // The halfedge of a boundary vertex must be a boundary one: OpenMesh relies on it.
  void turn_boundary_vertices() {
    for (Index h = 0; h < om_->n_halfedges(); ++h) {
      if (om_->face_handle(halfedge(h)).is_valid()) continue;
      const VertexHandle v = om_->from_vertex_handle(halfedge(h));
      if (om_->is_boundary(om_->halfedge_handle(v))) fail_at(v);
      om_->set_halfedge_handle(v, halfedge(h));
    }
  }

  void require_one_fan_each() const {
    std::vector<Index> corners(list_.vertices);
    for (const Index v : list_.corners) ++corners[v];
    for (Index v = 0; v < list_.vertices; ++v)
      if (corners[v] > 0 && fan_size(om_->halfedge_handle(vertex(v))) != corners[v]) fail_at(vertex(v));
  }

  // Clockwise: from the boundary, if there is one, to its other end.
  Index fan_size(HalfedgeHandle first) const {
    Index n = 0;
    HalfedgeHandle h = first;
    do {
      if (!om_->is_boundary(h)) ++n;
      h = om_->next_halfedge_handle(om_->opposite_halfedge_handle(h));
    } while (h.is_valid() && h != first);
    return n;
  }

  void link_boundary() {
    for (Index h = 0; h < om_->n_halfedges(); ++h)
      if (om_->is_boundary(halfedge(h)))
        om_->set_next_halfedge_handle(halfedge(h), om_->halfedge_handle(om_->to_vertex_handle(halfedge(h))));
  }

  [[noreturn]] static void fail(std::size_t f, const std::string& why) {
    throw InputError("facet " + std::to_string(f) + " does not fit, the mesh is not manifold there: " + why +
                     "; cut the mesh first (multimesh::cut)");
  }

  /// Several fans meet in v: names the first facet that is not in the first one.
  [[noreturn]] void fail_at(VertexHandle v) const {
    std::set<int> fan;
    for (std::size_t f = 0; f < list_.size(); ++f)
      for (const Index corner : list_.facet(f)) {
        if (static_cast<int>(corner) != v.idx()) continue;
        const auto at = static_cast<int>(f);
        if (fan.empty()) fan = fan_around(v, FaceHandle(at));
        if (!fan.contains(at)) fail(f, "vertex " + std::to_string(v.idx()) + " joins several fans of facets");
      }
    throw InputError("vertex " + std::to_string(v.idx()) + " joins several fans of facets");
  }

  std::set<int> fan_around(VertexHandle v, FaceHandle f) const {
    HalfedgeHandle first = om_->halfedge_handle(f);  // becomes the outgoing one
    while (om_->from_vertex_handle(first) != v) first = om_->next_halfedge_handle(first);
    std::set<int> fan;
    const auto add = [&](HalfedgeHandle h) {
      return !om_->is_boundary(h) && fan.insert(om_->face_handle(h).idx()).second;
    };
    for (auto h = first; add(h);) h = om_->opposite_halfedge_handle(om_->prev_halfedge_handle(h));
    for (auto h = om_->opposite_halfedge_handle(first); add(h);)
      h = om_->opposite_halfedge_handle(om_->next_halfedge_handle(h));
    return fan;
  }

  const FacetList& list_;
  std::unique_ptr<PolyConnectivity> om_ = std::make_unique<PolyConnectivity>();
  std::vector<Index> halfedges_;  // per corner, the one that begins there
};

// The facets are the vertices: each of them once, and in order.
std::unique_ptr<PolyConnectivity> make_points(const FacetList& list) {
  if (list.size() != list.vertices)
    throw InputError(std::to_string(list.size()) + " points of " + std::to_string(list.vertices) +
                     " vertices: each must be one");
  for (Index f = 0; f < list.size(); ++f)
    if (list.corners[f] != f)
      throw InputError("point " + std::to_string(f) + " is vertex " + std::to_string(list.corners[f]) +
                       ", not that of its own number");
  auto om = std::make_unique<PolyConnectivity>();
  om->resize(list.vertices, 0, 0);
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
  if (list.dimension < 0 || list.dimension > 2)
    throw InputError("OpenMesh holds points, edges and triangles, not facets of dimension " +
                     std::to_string(list.dimension));
  for (std::size_t c = 0; c < list.corners.size(); ++c)
    if (list.corners[c] >= list.vertices)
      throw InputError("facet " + std::to_string(c / list.corners_per_facet()) + " names vertex " +
                       std::to_string(list.corners[c]) + " of " + std::to_string(list.vertices));
  if (list.dimension == 0) return std::make_unique<PointMesh>(make_points(list));
  if (list.dimension == 1) return std::make_unique<EdgeMesh>(make_edges(list));
  return std::make_unique<TriangleMesh>(TriangleBuilder(list).run(), TriangleMesh::Checked{});
}

}  // namespace multimesh::openmesh
