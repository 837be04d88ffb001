// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <vector>

#include "multimesh/attribute.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// Keeps a surface that was cut so that its copies can be joined again without making new non-manifold edges, or
/// more copies when it is read: no two edges of different sheets may come to join the same two input vertices,
/// and no copy inside a sheet may come to its boundary. Labelled vertices of the
/// root are copies; `source` says of which input vertex.
class CopiesStayApart final : public Invariant {
 public:
  explicit CopiesStayApart(const std::vector<Index>& source)
      : Invariant("copies stay apart"), source_(source) {}
  bool before(const Event& event) override;

 private:
  void collect_labelled_neighbours(const Mesh& mesh, Dart vertex, std::vector<Index>& out);

  const std::vector<Index>& source_;
  DartBuffer star_, around_;
  std::vector<Index> kept_, gained_, other_;
};

/// Collapses may not give both sides of a seam edge the same texture coordinates: files tell vertices of the
/// texture apart by their values, so that such a seam would be closed when the file is read again. It happens
/// where charts touch in points: between two such points, a seam is open only at the vertices in between.
class SeamsStayOpen final : public Invariant {
 public:
  explicit SeamsStayOpen(const VertexAttribute<OpenMesh::Vec2d>& texcoords)
      : Invariant("seams stay open", texcoords.node()), texture_(texcoords.node()), texcoords_(texcoords) {}
  bool before(const Event& event) override;

 private:
  bool open_around(const Event& event, Dart end) const;
  OpenMesh::Vec2d merged(const Event& event, Index vertex) const;

  NodeId texture_;
  const VertexAttribute<OpenMesh::Vec2d>& texcoords_;
  mutable DartBuffer star_, sides_;
};

}  // namespace multimesh
