// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <vector>

#include "multimesh/invariant.hpp"

namespace multimesh {

/// Collapses may not make an edge between two labelled vertices of the root: these are copies of vertices at
/// which the surface was cut, and another sheet may have that edge too.
class CopiesStayApart final : public Invariant {
 public:
  CopiesStayApart() : Invariant("copies stay apart") {}
  bool before(const Event& event) override;

 private:
  DartBuffer star_;
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
  using Triangle = std::array<OpenMesh::Vec2d, 3>;
  int sign(const Triangle& t) const;
  bool keeps_signs(const Mesh& mesh, Dart end, Index other, const OpenMesh::Vec2d& moved);
  void orient_charts(const Mesh& mesh);

  NodeId texture_;
  const std::vector<OpenMesh::Vec2d>& texcoords_;
  double no_area_;                    ///< twice the area below which a triangle counts as having none
  std::vector<signed char> chart_sign_;  ///< per facet
  DartBuffer star_;
};

}  // namespace multimesh
