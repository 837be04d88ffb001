// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "multimesh/geometry/vector.hpp"
#include "multimesh/keeps_orientation.hpp"
#include "multimesh/openmesh/add_values.hpp"
#include "multimesh/openmesh/attached_tree.hpp"
#include "multimesh/openmesh/corner_values.hpp"
#include "multimesh/openmesh/mean.hpp"
#include "multimesh/openmesh/property_handle.hpp"

namespace multimesh::openmesh {

/// When the texture coordinates of the user's halfedges are updated from those of the texture's vertices.
enum class WriteBack {
  each_operation,  ///< always; undone with the operation
  on_demand,       ///< when write_back() is called: faster
};

/// Attaches a user's own OpenMesh mesh, any TriMesh_ArrayKernelT or triangulated PolyMesh_ArrayKernelT with
/// any traits, as the root of a multimesh, in place: nothing is copied; its properties, handles, status bits
/// and property managers stay valid. Children are made from data that the mesh already has.
///
///     openmesh::Attached attached(mesh);
///     const NodeId texture = attached.add_texture();
///     const NodeId creases = attached.add_features();
///     Outcome o = attached.collapse(h);         // in all three meshes, or refused in all three
///
/// OpenMesh's standard properties follow the operations: points, and vertex normals, colours and texture
/// coordinates, interpolated on the edge. Face properties, of any name and type, go to the halves of a split
/// face, and edge properties to the halves of an edge; the merged vertex of a collapse keeps those of the end
/// whose place it takes. follow() adds the user's own vertex properties. After the destruction of the
/// Attached, the mesh is an ordinary OpenMesh mesh with nothing of ours in it; dead elements are still marked
/// as deleted, as after OpenMesh's own operations, unless garbage_collection() was called.
///
/// During its lifetime, the mesh must not be moved, assigned, cleared or destroyed. Other edits of its
/// connectivity are detected (docs/openmesh.md).
template <class UserMesh>
class Attached : public AttachedTree {
 public:
  using Point = typename UserMesh::Point;
  using TexCoord = typename UserMesh::TexCoord2D;

  /// \throw InputError naming the first face that is not a triangle, vertex that is not manifold, or pair of
  /// simplices with the same vertices (ManifoldCut separates these); UsageError if the mesh is already
  /// attached. Cost: linear, plus a sort
  explicit Attached(UserMesh& mesh, Watching edits = Watching::on)
      : AttachedTree(mesh, edits),
        mesh_(mesh),
        points_(follow_values(NodeId::root, values(mesh.points_pph()))) {
    if (mesh.has_vertex_normals())
      follow_values(NodeId::root, values(mesh.vertex_normals_pph()),
                    mean_direction(values(mesh.vertex_normals_pph())));
    if (mesh.has_vertex_colors()) follow_values(NodeId::root, values(mesh.vertex_colors_pph()));
    if (mesh.has_vertex_texcoords2D()) follow_values(NodeId::root, values(mesh.vertex_texcoords2D_pph()));
  }

  UserMesh& mesh() noexcept { return mesh_; }
  VertexAttribute<Point>& points() noexcept { return points_; }

  /// Adds the texture: a mesh over the triangles, with one vertex per place in the texture, from the texture
  /// coordinates of the mesh's halfedges. `textured`: which faces have some; default: all. \throw UsageError
  /// if the mesh has no such coordinates, or has a texture that was not detached; InputError naming a face
  /// whose coordinates are not finite. Cost: O(n log n)
  NodeId add_texture(const std::function<bool(OpenMesh::FaceHandle)>& textured = {},
                     WriteBack when = WriteBack::each_operation) {
    require_no_texture(mesh_.has_halfedge_texcoords2D());
    const OpenMesh::BaseProperty& at_corners = mesh_.property(mesh_.halfedge_texcoords2D_pph());
    if (when == WriteBack::each_operation) require_carried(at_corners);
    std::vector<TexCoord>& at_halfedges = values(mesh_.halfedge_texcoords2D_pph());
    std::vector<Vec2> places(at_halfedges.size());
    for (std::size_t h = 0; h < places.size(); ++h) places[h] = {at_halfedges[h][0], at_halfedges[h][1]};
    const TextureChild child = add_texture_node(textured, places);
    std::vector<TexCoord>& at_vertices =
        add_values(child_connectivity(child.node), OpenMesh::VPropHandleT<TexCoord>(), "texcoord");
    for (std::size_t v = 0; v < at_vertices.size(); ++v) at_vertices[v] = at_halfedges[child.texcoord[v]];
    texcoords_ = &follow_values(child.node, at_vertices);
    corners_ = &keep(std::make_unique<CornerValues<TexCoord>>(tree(), child.node, at_vertices, at_halfedges),
                     when == WriteBack::each_operation);
    if (when == WriteBack::each_operation)
      leave(at_corners, [this, node = child.node] { return tree().contains(node); });
    return child.node;
  }
  /// Whether add_texture() was called, and its mesh not detached.
  bool has_texture() const { return texcoords_ != nullptr && tree().contains(texcoords_->node()); }
  /// Texture coordinates per vertex of the texture. \throw UsageError if add_texture() was not called
  VertexAttribute<TexCoord>& texcoords() {
    require_texture(texcoords_ != nullptr);
    return *texcoords_;
  }
  /// Forbids all triangles of the texture to flip or lose their area. \throw UsageError if there is none
  void forbid_flips() {
    require_texture(texcoords_ != nullptr && tree().contains(texcoords_->node()));
    if (std::exchange(without_flips_, texcoords_) == texcoords_) return;
    keep(std::make_unique<KeepsOrientation>(*texcoords_, tree().mesh(texcoords_->node())));
  }
  /// Sets the texture coordinates of the mesh's halfedges, if the texture was not detached. \throw UsageError
  /// if add_texture() was not called. Cost: linear
  void write_back() {
    require_texture(corners_ != nullptr);
    if (corners_ && tree().contains(corners_->node())) corners_->write_all();
  }

  /// Adds borders between faces with different tags, as curves: a property of the faces, or FProp.
  template <class Tag>
  NodeId add_borders(OpenMesh::FPropHandleT<Tag> tag) {
    return add_edges([this, tag](OpenMesh::EdgeHandle e) {
      const auto x = mesh_.face_handle(mesh_.halfedge_handle(e, 0)),
                 y = mesh_.face_handle(mesh_.halfedge_handle(e, 1));
      return x.is_valid() && y.is_valid() && !(mesh_.property(tag, x) == mesh_.property(tag, y));
    });
  }
  template <FacePropertyManager Tags>
  NodeId add_borders(const Tags& tags) {
    return add_borders(tags.getRawProperty());
  }
  /// Adds the faces with one tag, as a mesh of their own.
  template <class Tag>
  NodeId add_region(OpenMesh::FPropHandleT<Tag> tag, const std::type_identity_t<Tag>& value) {
    return add_faces([&](OpenMesh::FaceHandle f) { return mesh_.property(tag, f) == value; });
  }
  template <FacePropertyManager Tags>
  NodeId add_region(const Tags& tags, const typename Tags::Value& value) {
    return add_region(tags.getRawProperty(), value);
  }

  /// Makes a vertex property of the user's own follow: interpolated (or taken from the nearer end, if it has
  /// no mean), or by a rule.
  template <class T>
  VertexAttribute<T>& follow(OpenMesh::VPropHandleT<T> property,
                             typename VertexAttribute<T>::Rule rule = {}) {
    return follow_values(NodeId::root, values(property), std::move(rule));
  }
  template <VertexPropertyManager P>
  VertexAttribute<typename P::Value>& follow(const P& property,
                                             typename VertexAttribute<typename P::Value>::Rule rule = {}) {
    return follow(property.getRawProperty(), std::move(rule));
  }

  // Properties of edges, faces and halfedges follow automatically (docs/openmesh.md); these calls give them
  // other rules. A halfedge has the value of the corner of its face that it points to. \throw UsageError if
  // the property already follows a rule, or inside a transaction
  template <class T>
  Column<T>& follow(OpenMesh::EPropHandleT<T> property, ColumnRules<T> rules = {}) {
    return follow_column(1, property, std::move(rules));
  }
  template <class T>
  Column<T>& follow(OpenMesh::FPropHandleT<T> property, ColumnRules<T> rules = {}) {
    return follow_column(2, property, std::move(rules));
  }
  template <class T>
  Column<T>& follow(OpenMesh::HPropHandleT<T> property, ColumnRules<T> rules = {}) {
    return follow_column(corners, property, std::move(rules));
  }

  /// Moves a vertex. Cost: constant, plus that of invariants.
  Outcome relocate(OpenMesh::VertexHandle v, const Point& p) {
    return operations().relocate(NodeId::root, dart(v),
                                 [&](const Event&) { points_.set(static_cast<Index>(v.idx()), p); });
  }

 private:
  template <class Handle>
  auto& values(Handle handle) {
    return mesh_.property(handle).data_vector();
  }
  template <class Handle, class T>
  Column<T>& follow_column(int k, Handle property, ColumnRules<T> rules) {
    tree().require_closed("follow()");
    require_carried(mesh_.property(property));
    auto& column = keep(std::make_unique<Column<T>>(NodeId::root, k, values(property), std::move(rules)));
    leave(mesh_.property(property), [] { return true; });
    return column;
  }
  template <class T>
  VertexAttribute<T>& follow_values(NodeId n, std::vector<T>& values,
                                    typename VertexAttribute<T>::Rule rule = {}) {
    if constexpr (IntegerVector<T>)
      if (!rule) rule = rounded_mean(values);
    return keep(rule ? std::make_unique<VertexAttribute<T>>(n, values, std::move(rule))
                     : std::make_unique<VertexAttribute<T>>(n, values));
  }

  UserMesh& mesh_;
  VertexAttribute<Point>& points_;
  VertexAttribute<TexCoord>* texcoords_ = nullptr;
  VertexAttribute<TexCoord>* without_flips_ = nullptr;
  CornerValues<TexCoord>* corners_ = nullptr;
};

}  // namespace multimesh::openmesh
