// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <vector>

#include "multimesh/invariant.hpp"

namespace multimesh {

/// Keeps a surface that was cut so that its copies can be joined again without making new non-manifold edges:
/// no two edges of different sheets may come to join the same two input vertices. Labelled vertices of the
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

/// Collapses may not turn a triangle of the root by more than an angle, nor make one degenerate. Triangles
/// without area may do what they like.
class NormalTurn final : public Invariant {
 public:
  /// `max_turn` in radians, below pi.
  NormalTurn(const std::vector<OpenMesh::Vec3d>& positions, double max_turn);
  bool before(const Event& event) override;

 private:
  bool keeps_normals(const Mesh& mesh, Dart end, Index other, const OpenMesh::Vec3d& moved);

  const std::vector<OpenMesh::Vec3d>& positions_;
  double min_cosine_;
  DartBuffer star_;
};

/// Collapses may not flip a triangle of the texture or take its area away. Flipped is judged against the
/// chart: its orientation is the sign of its total area when the invariant is made, so that mirrored charts
/// decimate like others. A triangle that is on the wrong side already may stay there or come right; one
/// without area may stay so or come right.
class TextureOrientation final : public Invariant {
 public:
  TextureOrientation(const MultiMesh& tree, NodeId texture, const std::vector<OpenMesh::Vec2d>& texcoords);
  bool before(const Event& event) override;

 private:
  int sign(double area, Index facet) const;
  bool keeps_signs(const Mesh& mesh, Dart end, Index other, const OpenMesh::Vec2d& moved);
  void orient_charts(const Mesh& mesh);

  NodeId texture_;
  const std::vector<OpenMesh::Vec2d>& texcoords_;
  // Areas are doubled here. Below these a triangle counts as having none: per chart, since its neighbours may
  // be far larger; and a triangle that is above the one of the whole texture may not fall below it.
  struct Chart {
    signed char sign = 0;
    double no_area = 0;
  };
  double no_area_;
  std::vector<Chart> charts_;
  std::vector<Index> chart_of_;  ///< per facet
  DartBuffer star_;
};

/// Collapses may not give both sides of a seam edge the same texture coordinates: files tell vertices of the
/// texture apart by their values, so that such a seam would be closed when the file is read again. It happens
/// where charts touch in points: between two such points, a seam is open only at the vertices in between.
class SeamsStayOpen final : public Invariant {
 public:
  SeamsStayOpen(NodeId texture, const std::vector<OpenMesh::Vec2d>& texcoords)
      : Invariant("seams stay open", texture), texture_(texture), texcoords_(texcoords) {}
  bool before(const Event& event) override;

 private:
  bool open_around(const Event& event, Dart end) const;
  OpenMesh::Vec2d merged(const Event& event, Index vertex) const;

  NodeId texture_;
  const std::vector<OpenMesh::Vec2d>& texcoords_;
  mutable DartBuffer star_, sides_;
};

}  // namespace multimesh
