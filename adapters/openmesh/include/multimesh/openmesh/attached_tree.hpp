// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "multimesh/column.hpp"
#include "multimesh/openmesh/texture_child.hpp"
#include "multimesh/openmesh/watch.hpp"
#include "multimesh/operations.hpp"

namespace multimesh::openmesh {

/// Handles of the user's that a renumbering updates, as in OpenMesh's garbage_collection(). Handles of
/// removed elements become invalid.
struct KeptHandles {
  std::vector<OpenMesh::VertexHandle*> vertices;
  std::vector<OpenMesh::HalfedgeHandle*> halfedges;
  std::vector<OpenMesh::EdgeHandle*> edges;
  std::vector<OpenMesh::FaceHandle*> faces;
};

/// The part of Attached that does not depend on the traits of the mesh.
class AttachedTree {
 public:
  AttachedTree(const AttachedTree&) = delete;
  AttachedTree& operator=(const AttachedTree&) = delete;

  MultiMesh& tree() noexcept { return tree_; }
  const MultiMesh& tree() const noexcept { return tree_; }
  /// All of the library's operations, on any mesh of the tree, with the attributes that are stored here.
  Propagation& operations() noexcept { return operations_; }

  // --- handles and darts of the root
  /// (from, to, ..) \throw UsageError for a halfedge of an edge without faces
  Dart dart(OpenMesh::HalfedgeHandle h) const;
  Dart dart(OpenMesh::EdgeHandle e) const { return dart(root_.halfedge_handle(e, 0)); }
  Dart dart(OpenMesh::VertexHandle v) const;
  /// \throw UsageError for a face that no longer exists
  Dart dart(OpenMesh::FaceHandle f) const;
  /// The halfedge on the edge of a dart, from its vertex. \throw UsageError for a dead dart
  OpenMesh::HalfedgeHandle halfedge(Dart d) const;

  // --- children of the root; all throw InputError if they would be empty. Cost: linear
  /// The edges whose status bit `feature` is set, as curves.
  NodeId add_features();
  /// The boundary, as curves.
  NodeId add_boundary();
  NodeId add_edges(const std::function<bool(OpenMesh::EdgeHandle)>& tagged);
  NodeId add_faces(const std::function<bool(OpenMesh::FaceHandle)>& tagged);
  /// Vertices that must be kept, as points.
  NodeId add_points(const std::function<bool(OpenMesh::VertexHandle)>& tagged);

  // --- operations by handles; others: operations()
  /// Splits an edge at (1-t) from + t to of its first halfedge.
  Outcome split(OpenMesh::EdgeHandle e, double t = 0.5) {
    return operations_.split(NodeId::root, dart(e), t);
  }
  /// Merges the from-vertex into the to-vertex, which keeps its place, as OpenMesh's collapse does.
  Outcome collapse(OpenMesh::HalfedgeHandle h, Placement placement = Placement::keep_b()) {
    return operations_.collapse(NodeId::root, dart(h), placement);
  }
  Outcome swap(OpenMesh::EdgeHandle e) { return operations_.swap(NodeId::root, dart(e)); }

  // --- maintenance
  /// Removes dead elements of all meshes for good; maps and the given handles follow. Cost: linear
  void garbage_collection(const KeptHandles& handles = {});
  /// Follows edits of the mesh by other code: MultiMesh::resync().
  void resync(const KeptHandles& handles = {});

 protected:
  AttachedTree(OpenMesh::PolyConnectivity& root, Watching edits);
  ~AttachedTree() = default;

  /// Owns an attribute as long as the operations, which refer to it by address. \return it; `follows`: it is
  /// notified of each operation
  template <class A>
  A& keep(std::unique_ptr<A> attribute, bool follows = true) {
    A& kept = *attribute;
    if (follows) operations_.add(kept);
    if constexpr (std::is_base_of_v<Attribute, A>) {
      attributes_.push_back(std::move(attribute));
    } else {
      invariants_.push_back(std::move(attribute));
    }
    return kept;
  }
  /// The operations leave a property to other code that writes it, as long as `still` returns true.
  void leave(const OpenMesh::BaseProperty& property, std::function<bool()> still);
  /// \throw UsageError if it was left to other code
  void require_carried(const OpenMesh::BaseProperty& property) const;
  void require_no_texture(bool has_texcoords) const;
  static void require_texture(bool has_texture);
  /// `places`: per halfedge. The result names a halfedge per vertex of the texture.
  TextureChild add_texture_node(const std::function<bool(OpenMesh::FaceHandle)>& textured,
                                const std::vector<Vec2>& places);
  OpenMesh::PolyConnectivity& child_connectivity(NodeId n);

 private:
  OpenMesh::PolyConnectivity& root_;
  MultiMesh tree_;
  Propagation operations_;
  std::vector<std::unique_ptr<Attribute>> attributes_;
  std::vector<std::unique_ptr<Invariant>> invariants_;
  std::optional<NodeId> texture_;
};

}  // namespace multimesh::openmesh
