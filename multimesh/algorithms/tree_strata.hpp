// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "multimesh/copy.hpp"

namespace multimesh {

/// What an edge of the root is besides being one: the meshes that have it as a curve or in their boundary.
/// Edges with the same are of one kind.
class EdgeKind {
 public:
  bool is_plain() const noexcept { return meshes_.empty(); }
  friend bool operator==(const EdgeKind&, const EdgeKind&) = default;

 private:
  friend class TreeStrata;
  std::vector<std::uint32_t> meshes_;  // by node; once per copy
};

/// Where a vertex of the root may go.
enum class Freedom : std::uint8_t {
  surface,  ///< anywhere on it
  line,     ///< along the two edges of one kind that meet there
  none,
};

/// The strata of a tree whose root is a surface: what runs along its edges, asked of the maps and not of
/// tags.
class TreeStrata {
 public:
  explicit TreeStrata(const MultiMesh& tree) : tree_(tree), root_(tree.mesh(NodeId::root)) {}

  /// From now on an edge whose number is 0 is plain without a look at its copies: who keeps the numbers
  /// answers for them. `numbers`: per edge of the root.
  void trust(const std::vector<Index>& numbers) noexcept { numbers_ = &numbers; }

  /// Of the edge of (a, b, ..). Cost: that of its copies
  EdgeKind kind(Dart e);
  bool is_plain(Dart e) { return kind(e).is_plain(); }
  /// Whether it may be neither split nor moved: an edge with a kind between two locked vertices.
  bool is_frozen(Dart e) {
    return root_.is_locked(root_.vertex(e)) &&
           root_.is_locked(root_.vertex(root_.reorder(e, exchange_ends))) && !is_plain(e);
  }
  /// \param line if it is on one: the two edges, as darts that begin with the vertex. Cost: that of its star
  Freedom freedom(Dart vertex, std::array<Dart, 2>& line);
  Freedom freedom(Dart vertex) {
    std::array<Dart, 2> line{};
    return freedom(vertex, line);
  }

 private:
  bool runs_through(Dart vertex, const EdgeKind& kind);

  const MultiMesh& tree_;
  const Mesh& root_;
  Copies copies_;
  DartBuffer edges_;
  const std::vector<Index>* numbers_ = nullptr;
};

}  // namespace multimesh
