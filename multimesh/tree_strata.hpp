// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "multimesh/copy.hpp"

namespace multimesh {

/// What an edge of a surface is besides an edge: the meshes that contain it as a curve or in their boundary.
/// Edges with the same meshes are of one kind.
class EdgeKind {
 public:
  bool is_plain() const noexcept { return meshes_.empty(); }
  friend bool operator==(const EdgeKind&, const EdgeKind&) = default;

 private:
  friend class TreeStrata;
  std::vector<std::uint32_t> meshes_;  // by node; once per copy
};

/// Where a vertex of a surface may move.
enum class Freedom : std::uint8_t {
  surface,  ///< anywhere on it
  line,     ///< along the two edges of one kind that meet there
  none,
};

/// The strata of a surface in a tree, at its root or below other meshes. What runs along its edges is found
/// from the maps, not from tags.
class TreeStrata {
 public:
  explicit TreeStrata(const MultiMesh& tree, NodeId surface = NodeId::root)
      : tree_(tree), node_(surface), mesh_(tree.mesh(surface)) {}

  /// Trusts the caller's numbers from now on: an edge with number 0 is plain, and its copies are not
  /// examined. `numbers`: per edge of the surface.
  void trust(const std::vector<Index>& numbers) noexcept { numbers_ = &numbers; }

  /// The kind of the edge of (a, b, ..). Cost: that of its copies
  EdgeKind kind(Dart e);
  bool is_plain(Dart e) { return kind(e).is_plain(); }
  /// Whether the edge may be neither split nor moved: an edge with a kind between two locked vertices.
  bool is_frozen(Dart e) {
    return is_locked(e) && is_locked(mesh_.reorder(e, exchange_ends)) && !is_plain(e);
  }
  /// Whether the vertex keeps its place in this mesh or the root.
  bool is_locked(Dart vertex) const;
  /// \param line if the vertex is on one: its two edges, darts that begin with the vertex. Cost: its star
  Freedom freedom(Dart vertex, std::array<Dart, 2>& line);
  Freedom freedom(Dart vertex) {
    std::array<Dart, 2> line{};
    return freedom(vertex, line);
  }

 private:
  bool runs_through(Dart vertex, const EdgeKind& kind);

  const MultiMesh& tree_;
  NodeId node_;
  const Mesh& mesh_;
  Copies copies_;
  DartBuffer edges_;
  const std::vector<Index>* numbers_ = nullptr;
};

}  // namespace multimesh
