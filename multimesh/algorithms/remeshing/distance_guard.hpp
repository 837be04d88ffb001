// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/remeshing/reference.hpp"
#include "multimesh/coordinates.hpp"

namespace multimesh::remeshing {

/// Keeps the surface near the input, and the input near the surface. Points of the input (its vertices, and
/// enough others to be dense) each belong to a triangle that is near. When triangles change, their points
/// must be near one of the triangles that replace them. Triangles that bend away from their neighbours are
/// also checked in the other direction.
class DistanceGuard {
 public:
  /// `bound`: distance; `spacing`: of the points. Cost: linear, and in area / spacing^2
  DistanceGuard(const Mesh& surface, const Coordinates& positions, const Reference& input, double bound,
                double spacing);

  /// Takes the points of triangles that are about to change.
  void take(const DartBuffer& triangles);
  /// Assigns them to the current triangles, if all points are near enough. Otherwise does nothing.
  bool settle(const DartBuffer& triangles);
  /// Assigns them to the current triangles, which are parts of the previous ones.
  void hand_on(const DartBuffer& triangles);
  /// Returns them to the triangles that had them.
  void give_back();
  /// Assigns all points to the nearest triangles, after other code has renumbered these. Cost: O(n log n)
  void sort_anew();

 private:
  struct Taken {
    Index point, triangle;
  };
  struct Candidate {
    spatial::Triangle triangle;
    Index facet;
  };
  void add_points(const spatial::Triangle& t, Index facet, double spacing);
  void add_point(const Vec3& p, Index facet);
  void find_nearest(const DartBuffer& triangles, double distance);
  Index nearest_candidate(const Taken& taken, double distance) const;
  void put_settled();
  void put(Index point, Index triangle);
  bool touches_boundary(Dart triangle) const;
  bool is_near_input(const DartBuffer& triangles) const;
  bool is_near_input(const spatial::Triangle& t) const;
  spatial::Triangle triangle(Dart d) const;

  const Mesh& mesh_;
  const Coordinates& positions_;
  const Reference& input_;
  double bound_;
  std::vector<Vec3> points_;
  std::vector<Index> next_;   // per point: one more than the next one of its triangle
  std::vector<Index> first_;  // per triangle: one more than its first point
  double due_ = 0;            // share of the next point
  double u_ = 0, v_ = 0;      // of the previous one
  std::vector<Taken> taken_;
  std::vector<Candidate> candidates_;
  std::vector<Index> settled_;
};

}  // namespace multimesh::remeshing
