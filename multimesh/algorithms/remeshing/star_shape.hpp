// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <array>
#include <optional>

#include "multimesh/algorithms/coordinates.hpp"
#include "multimesh/dart.hpp"

namespace multimesh::remeshing {

/// Judges triangles of one mesh before they are changed.
class StarShape {
 public:
  /// \param planar in the plane no triangle may change its side, in space none may turn by much
  StarShape(const Mesh& mesh, const Coordinates& at, bool planar) : mesh_(mesh), at_(at), planar_(planar) {}

  /// Whether the triangles around a vertex keep their side if it goes to `to`; those with `without` are left
  /// out.
  bool allows(Dart vertex, const OpenMesh::Vec3d& to, Index without = no_index);
  /// Whether (a,b,l), (b,a,r) may become (a,r,l), (r,b,l).
  bool allows_swap(Dart edge);

 private:
  using Triangle = std::array<OpenMesh::Vec3d, 3>;
  bool same_side(const Triangle& before, const Triangle& after) const;

  const Mesh& mesh_;
  const Coordinates& at_;
  bool planar_;
  DartBuffer star_;
};

/// The least of its angles, radians; 0 for a triangle without area.
double least_angle(const OpenMesh::Vec3d& a, const OpenMesh::Vec3d& b, const OpenMesh::Vec3d& c);

}  // namespace multimesh::remeshing
