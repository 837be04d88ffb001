// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "multimesh/coordinates.hpp"
#include "multimesh/keeps_orientation.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/simplices_stay.hpp"

namespace multimesh {

/// A tree of meshes with everything that an algorithm needs to work on any mesh of it: which values are
/// coordinates and of what kind, what else follows the operations, and which invariants they must keep. Each
/// domain holds one; an algorithm works on an EmbeddedMesh.
class Embedding {
 public:
  enum class Kind {
    space,  ///< where the vertices are
    chart,  ///< a place in the plane, as texture coordinates; triangles there must not flip
  };

  explicit Embedding(MultiMesh& tree) : operations_(tree) {}
  /// Attributes and invariants that are already in `operations` belong to the embedding.
  explicit Embedding(const Propagation& operations) : operations_(operations) {}

  const MultiMesh& tree() const noexcept { return operations_.tree(); }

  /// Adds an attribute or an invariant, and owns it.
  template <class T, class... Arguments>
  T& add(Arguments&&... arguments) {
    auto owned = std::make_shared<T>(std::forward<Arguments>(arguments)...);
    operations_.add(*owned);
    owned_.push_back(owned);
    return *owned;
  }
  /// Adds one that is not owned; it must outlive the embedding.
  void add(Attribute& a) { operations_.add(a); }
  void add(Invariant& i) { operations_.add(i); }
  void set(const LegalityOptions& o) { operations_.set(o); }

  /// Declares the values of an attribute, which already follows the operations, to be coordinates.
  template <class T>
  Coordinates& add_coordinates(VertexAttribute<T>& values, Kind kind) {
    return add_coordinates(std::make_unique<CoordinatesOf<T>>(values), kind);
  }
  Coordinates& add_coordinates(std::unique_ptr<Coordinates> coordinates, Kind kind) {
    coordinates_.push_back({std::move(coordinates), kind});
    return *coordinates_.back().coordinates;
  }
  /// For a mesh of curves: which of its edges exist only because charts are cut open along them. The place of
  /// such edges in space matters less than that of others. Without it there are none.
  void mark_seams(NodeId curves, std::function<bool(Index edge)> is_only_seam) {
    seams_.emplace_back(curves, std::move(is_only_seam));
  }
  bool is_only_seam(NodeId curves, Index edge) const;
  /// The coordinates in space that this mesh has of its own, or null.
  Coordinates* positions(NodeId n) const { return find(n, Kind::space); }
  bool is_chart(NodeId n) const { return find(n, Kind::chart) != nullptr; }

  // --- what no operation may change
  /// No facet of the mesh of these coordinates may turn over, see KeepsOrientation.
  void keep_orientation(const Coordinates& c, const Vec3& normal = {0, 0, 1}) {
    orientations_.push_back(std::make_unique<KeepsOrientation>(c, normal));
  }
  /// These facets stay as they are, see SimplicesStay.
  void keep(std::string name, SimplicesStay::Stays stays) {
    kept_.facets.push_back(&add<SimplicesStay>(std::move(name), std::move(stays)));
  }
  /// Says which edges of a mesh some other invariant keeps.
  void tell_kept_edges(NodeId n, std::function<bool(Dart edge)> kept) {
    kept_.edges.emplace_back(n, std::move(kept));
  }
  /// Says to which part of the mesh each facet belongs, in a list that follows the operations. Faces between
  /// parts count as walls.
  void tell_parts(NodeId n, const std::vector<std::int32_t>& part) { kept_.parts.emplace_back(n, &part); }
  const Kept& kept() const noexcept { return kept_; }

 private:
  friend class EmbeddedMesh;
  struct Known {
    std::unique_ptr<Coordinates> coordinates;
    Kind kind;
  };
  Coordinates* find(NodeId n, Kind kind) const;

  Propagation operations_;
  std::vector<std::shared_ptr<void>> owned_;
  std::vector<Known> coordinates_;
  std::vector<std::pair<NodeId, std::function<bool(Index)>>> seams_;
  std::vector<std::unique_ptr<KeepsOrientation>> orientations_;
  Kept kept_;
};

/// One mesh of an embedding during a run of an algorithm: operations that carry everything the embedding has,
/// and coordinates of the mesh in space, taken from the nearest mesh above if it has none of its own. The
/// embedding must outlive this object, and nothing may be added to it. Other code may change the tree in
/// between if the vertices of this mesh keep their places.
class EmbeddedMesh {
 public:
  /// \param judges_orientation the algorithm itself asks the exact sign of each facet of this mesh before it
  /// makes it: the embedding does not, neither of vertices that are there for a moment, as in a swap.
  /// \throw UsageError if there are no coordinates in space. Cost: linear, if they are those of a mesh above
  EmbeddedMesh(const Embedding& embedding, NodeId n, bool judges_orientation = false);

  NodeId node() const noexcept { return node_; }
  const MultiMesh& tree() const noexcept { return operations_.tree(); }
  const Mesh& mesh() const noexcept { return mesh_; }
  Propagation& operations() noexcept { return operations_; }
  Coordinates& positions() const noexcept { return *positions_; }
  /// Attributes of its operations that the embedding does not have: positions taken from above.
  std::vector<Attribute*> inherited() const;
  /// The charts of the meshes of this dimension below it.
  std::span<Coordinates* const> charts() const noexcept { return charts_; }
  const Embedding& embedding() const noexcept { return embedding_; }

 private:
  const Embedding& embedding_;
  NodeId node_;
  Propagation operations_;
  const Mesh& mesh_;
  std::vector<std::unique_ptr<CoordinatesFromParent>> inherited_;
  Coordinates* positions_ = nullptr;
  std::vector<Coordinates*> charts_;
};

}  // namespace multimesh
