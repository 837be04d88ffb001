// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/attached_tree.hpp"

#include <cmath>
#include <string>

#include "adapters/openmesh/cut_labels.hpp"
#include "multimesh/build.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"

namespace multimesh::openmesh {

namespace {

const TriangleMesh& triangles(const MultiMesh& tree) {
  return static_cast<const TriangleMesh&>(tree.mesh(NodeId::root));
}

template <class Handle>
void rename(const std::vector<Handle*>& handles, const std::vector<Index>& moved) {
  for (Handle* h : handles) {
    if (!h->is_valid()) continue;
    const auto old = static_cast<std::size_t>(h->idx());
    *h = old < moved.size() && moved[old] != no_index ? Handle(static_cast<int>(moved[old])) : Handle();
  }
}

void rename(const KeptHandles& handles, const Compaction& moved) {
  if (moved.simplices.empty()) return;
  rename(handles.vertices, moved.simplices[0]);
  rename(handles.edges, moved.simplices[1]);
  rename(handles.faces, moved.simplices[2]);
  for (OpenMesh::HalfedgeHandle* h : handles.halfedges) {
    OpenMesh::EdgeHandle e(h->is_valid() ? h->idx() >> 1 : -1);
    rename(std::vector{&e}, moved.simplices[1]);
    *h = e.is_valid() ? OpenMesh::HalfedgeHandle(2 * e.idx() + (h->idx() & 1)) : OpenMesh::HalfedgeHandle();
  }
}

}  // namespace

AttachedTree::AttachedTree(OpenMesh::PolyConnectivity& root, Watching edits)
    : root_(root), tree_(std::make_unique<TriangleMesh>(root, edits)), operations_(tree_) {
  if (const auto* labels = cut_labels(root)) keep(std::make_unique<CopiesCanBeJoined>(*labels));
}

Dart AttachedTree::dart(OpenMesh::HalfedgeHandle h) const {
  const bool known = h.is_valid() && static_cast<std::size_t>(h.idx()) < root_.n_halfedges();
  const Dart d = known ? triangles(tree_).edge_dart(h) : no_dart;
  if (d == no_dart)
    throw UsageError("halfedge " + std::to_string(h.idx()) + " is not one of an edge with faces");
  return d;
}

Dart AttachedTree::dart(OpenMesh::VertexHandle v) const {
  const Dart d = v.is_valid() && static_cast<std::size_t>(v.idx()) < root_.n_vertices()
                     ? triangles(tree_).dart_of(0, static_cast<Index>(v.idx()))
                     : no_dart;
  if (d == no_dart) throw UsageError("vertex " + std::to_string(v.idx()) + " is not one of a face");
  return d;
}

Dart AttachedTree::dart(OpenMesh::FaceHandle f) const {
  const bool known = f.is_valid() && static_cast<std::size_t>(f.idx()) < root_.n_faces();
  if (!known || root_.status(f).deleted())
    throw UsageError("face " + std::to_string(f.idx()) + " is not one of the mesh");
  return dart(root_.halfedge_handle(f));
}

OpenMesh::HalfedgeHandle AttachedTree::halfedge(Dart d) const {
  tree_.require_dart(NodeId::root, d);
  const auto h = TriangleMesh::halfedge(d);
  const auto from = static_cast<Index>(root_.to_vertex_handle(OpenMesh::HalfedgeHandle(h.idx() ^ 1)).idx());
  return triangles(tree_).vertex(d) == from ? h : OpenMesh::HalfedgeHandle(h.idx() ^ 1);
}

NodeId AttachedTree::add_features() {
  return add_edges([this](OpenMesh::EdgeHandle e) { return root_.status(e).feature(); });
}

NodeId AttachedTree::add_boundary() {
  return add_child_from_boundary(tree_, NodeId::root, make_mesh);
}

NodeId AttachedTree::add_edges(const std::function<bool(OpenMesh::EdgeHandle)>& tagged) {
  return add_child_from_tags(
      tree_, NodeId::root, 1, [&](Index e) { return tagged(OpenMesh::EdgeHandle(static_cast<int>(e))); },
      make_mesh);
}

NodeId AttachedTree::add_faces(const std::function<bool(OpenMesh::FaceHandle)>& tagged) {
  return add_child_from_tags(
      tree_, NodeId::root, 2, [&](Index f) { return tagged(OpenMesh::FaceHandle(static_cast<int>(f))); },
      make_mesh);
}

NodeId AttachedTree::add_points(const std::function<bool(OpenMesh::VertexHandle)>& tagged) {
  return add_child_from_tags(
      tree_, NodeId::root, 0, [&](Index v) { return tagged(OpenMesh::VertexHandle(static_cast<int>(v))); },
      make_mesh);
}

void AttachedTree::leave(const OpenMesh::BaseProperty& property, std::function<bool()> still) {
  static_cast<Connectivity&>(tree_.mesh(NodeId::root)).leave(property, std::move(still));
}

void AttachedTree::require_carried(const OpenMesh::BaseProperty& property) const {
  if (static_cast<const Connectivity&>(tree_.mesh(NodeId::root)).is_left(property))
    throw UsageError("the property \"" + property.name() + "\" follows the operations by a rule already");
}

void AttachedTree::require_no_texture(bool has_texcoords) const {
  if (!has_texcoords)
    throw UsageError("the mesh has no texture coordinates on halfedges; request_halfedge_texcoords2D()");
  if (texture_ && tree_.contains(*texture_))
    throw UsageError("the mesh has a texture already; detach it first");
}

void AttachedTree::require_texture(bool has_texture) {
  if (!has_texture) throw UsageError("the mesh has no texture; call add_texture() first");
}

TextureChild AttachedTree::add_texture_node(const std::function<bool(OpenMesh::FaceHandle)>& textured,
                                            const std::vector<Vec2>& places) {
  TexturedCorners corners;
  for (const auto f : root_.all_faces()) {
    if (root_.status(f).deleted() || (textured && !textured(f))) continue;
    corners.facets.push_back(static_cast<Index>(f.idx()));
    for (const auto h : root_.fh_range(f)) {
      const Vec2& place = places[static_cast<std::size_t>(h.idx())];
      if (!std::isfinite(place[0]) || !std::isfinite(place[1]))
        throw InputError("face " + std::to_string(f.idx()) + ": the texture coordinates of halfedge " +
                         std::to_string(h.idx()) +
                         " are not finite; set them, or leave the face out of the texture");
      corners.corners.push_back(static_cast<Index>(root_.to_vertex_handle(h).idx()));
      corners.texcoord.push_back(static_cast<Index>(h.idx()));
    }
  }
  TextureChild child = add_texture_child(tree_, NodeId::root, std::move(corners), places);
  texture_ = child.node;
  return child;
}

OpenMesh::PolyConnectivity& AttachedTree::child_connectivity(NodeId n) {
  return static_cast<Connectivity&>(tree_.mesh(n)).openmesh();
}

void AttachedTree::garbage_collection(const KeptHandles& handles) {
  rename(handles, tree_.compact().front());
}

void AttachedTree::resync(const KeptHandles& handles) {
  rename(handles, tree_.resync().front());
}

}  // namespace multimesh::openmesh
