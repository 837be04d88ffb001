// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "multimesh/coordinates.hpp"
#include "multimesh/dart.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::remeshing {

/// Judges triangles of one mesh in space before they are changed.
class StarShape {
 public:
  StarShape(const Mesh& mesh, const Coordinates& at) : mesh_(mesh), at_(at) {}

  /// Whether the triangles around a vertex keep their side if it moves to `to`; triangles that contain
  /// `without` are left out. None may turn by much, or become flat.
  bool allows(Dart vertex, const Vec3& to, Index without = no_index);
  /// Whether (a,b,l), (b,a,r) may become (a,r,l), (r,b,l).
  bool allows_swap(Dart edge);

 private:
  const Mesh& mesh_;
  const Coordinates& at_;
  DartBuffer star_;
};

/// Whether a triangle is flatter than those that are made where there is a choice: its largest angle is near
/// 180 degrees.
bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c);

/// The least of its angles, radians; 0 for a triangle without area.
double least_angle(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace multimesh::remeshing
