// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/remeshing/changed_triangles.hpp"
#include "multimesh/coordinates.hpp"
#include "multimesh/dart.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::remeshing {

/// Judges triangles of a mesh in the plane. None may change its orientation, by the exact sign, or lose its
/// area; one without area may only get the orientation of all others around.
class PlaneSides {
 public:
  /// Cost: linear.
  PlaneSides(const Mesh& mesh, const Coordinates& at);

  /// As in StarShape.
  bool allows(Dart vertex, const Vec3& to, Index without = no_index);
  bool allows_swap(Dart edge);

  /// Counts triangles by orientation: around edges before a split, and around the new vertices after
  /// it.
  struct Count {
    std::size_t left = 0, right = 0, none = 0, tiny = 0;
  };
  /// Adds the triangles around the k-simplex of d.
  void count(Dart d, int k, Count& sum);
  /// Whether no triangle flipped or lost its area when each was halved.
  static bool halved(const Count& before, const Count& after);

 private:
  Corners triangle(Dart d) const;
  /// \param none the orientation that a triangle without area may get
  bool keeps_side(const Corners& before, const Corners& after, int none) const;
  /// The orientation of the triangles in star_; 0 if they have both.
  int common_side() const;

  const Mesh& mesh_;
  const Coordinates& at_;
  double tiny_ = 0;
  DartBuffer star_;
};

}  // namespace multimesh::remeshing
