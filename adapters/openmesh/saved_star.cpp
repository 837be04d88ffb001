// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/saved_star.hpp"

namespace multimesh::openmesh {

using OpenMesh::FaceHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

void SavedStar::add(HalfedgeHandle h) {
  halfedges_.push_back({h, mesh_.next_halfedge_handle(h), mesh_.prev_halfedge_handle(h),
                        mesh_.to_vertex_handle(h), mesh_.face_handle(h),
                        mesh_.status(mesh_.edge_handle(h)).bits(),
                        mesh_.has_halfedge_status() ? mesh_.status(h).bits() : 0});
}

void SavedStar::add(VertexHandle v) {
  vertices_.push_back({v, mesh_.halfedge_handle(v), mesh_.status(v).bits()});
}

void SavedStar::add(FaceHandle f) {
  if (f.is_valid()) faces_.push_back({f, mesh_.halfedge_handle(f), mesh_.status(f).bits()});
}

// A collapse writes halfedges of the edges at the vertex and of the faces there, and those linked to them.
void SavedStar::save(VertexHandle vertex) {
  halfedges_.clear();
  vertices_.clear();
  faces_.clear();
  add(vertex);
  const HalfedgeHandle first = mesh_.halfedge_handle(vertex);
  HalfedgeHandle h = first;
  do {
    add(mesh_.to_vertex_handle(h));
    add(mesh_.face_handle(h));
    for (const HalfedgeHandle side : {h, mesh_.opposite_halfedge_handle(h)}) {
      add(side);
      add(mesh_.next_halfedge_handle(side));
      add(mesh_.prev_halfedge_handle(side));
    }
    const HalfedgeHandle across = mesh_.opposite_halfedge_handle(mesh_.next_halfedge_handle(h));
    add(across);
    add(mesh_.next_halfedge_handle(across));
    add(mesh_.prev_halfedge_handle(across));
    h = mesh_.opposite_halfedge_handle(mesh_.prev_halfedge_handle(h));
  } while (h != first);
}

// All `next` before all `prev`: setting `next` also writes `prev` of a halfedge that may have been another's.
void SavedStar::restore() {
  for (const Halfedge& s : halfedges_) {
    mesh_.set_vertex_handle(s.h, s.to);
    mesh_.set_next_halfedge_handle(s.h, s.next);
    s.face.is_valid() ? mesh_.set_face_handle(s.h, s.face) : mesh_.set_boundary(s.h);
    mesh_.status(mesh_.edge_handle(s.h)).set_bits(s.edge_status);
    if (mesh_.has_halfedge_status()) mesh_.status(s.h).set_bits(s.status);
  }
  for (const Halfedge& s : halfedges_) mesh_.set_prev_halfedge_handle(s.h, s.prev);
  for (const Vertex& s : vertices_) {
    mesh_.set_halfedge_handle(s.v, s.halfedge);
    mesh_.status(s.v).set_bits(s.status);
  }
  for (const Face& s : faces_) {
    mesh_.set_halfedge_handle(s.f, s.halfedge);
    mesh_.status(s.f).set_bits(s.status);
  }
}

}  // namespace multimesh::openmesh
