// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "multimesh/attribute.hpp"
#include "multimesh/geometry/vector.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// Keeps a surface that was cut such that its copies can be joined again without new non-manifold edges, or
/// more copies when it is read. No two edges of different sheets may come to join the same two input vertices
/// by a collapse or a swap. Two edges that already do are neither split nor swapped, because the other one
/// would not be. No copy inside a sheet may come to its boundary. Locked vertices of the root are copies, or
/// other vertices that stay; `source` gives the input vertex.
class CopiesStayApart final : public Invariant {
 public:
  /// Cost: linear.
  CopiesStayApart(const Mesh& root, const std::vector<Index>& source);
  bool before(const Event& event) override;

 private:
  bool collapse_allowed(const Event& event);
  /// Whether an edge other than `edge` joins the two vertices after copies are joined again.
  bool joined(const Mesh& mesh, Index v, Index w, Index edge);
  std::span<const Index> copies_of(const Index& v) const;
  void collect_labelled_neighbours(const Mesh& mesh, Dart vertex, std::vector<Index>& out);

  const std::vector<Index>& source_;
  std::unordered_map<Index, std::vector<Index>> copies_;  // by source; only sources that have several
  DartBuffer star_, around_;
  std::vector<Index> kept_, gained_, other_;
};

/// No operation may give both sides of a seam edge the same texture coordinates: files tell vertices of the
/// texture apart by value, so the seam would be closed when the file is read again. This can happen where
/// charts touch in points: between two such points, a seam is open only at the vertices in between.
class SeamsStayOpen final : public Invariant {
 public:
  explicit SeamsStayOpen(const VertexAttribute<Vec2>& texcoords)
      : Invariant("seams stay open", texcoords.node()), texture_(texcoords.node()), texcoords_(texcoords) {}
  bool before(const Event& event) override;
  bool after(const Event& event) override;

 private:
  using Value = std::function<Vec2(Index vertex)>;
  /// Whether the sides of all seams around the vertex of d, except at one edge, differ.
  bool open_around(const MultiMesh& tree, Dart d, Index without, const Value& near_end) const;
  Vec2 merged(const Event& event, Index vertex) const;

  NodeId texture_;
  const VertexAttribute<Vec2>& texcoords_;
  mutable DartBuffer star_, sides_;
};

}  // namespace multimesh
