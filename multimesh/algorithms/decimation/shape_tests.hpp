// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "multimesh/algorithms/decimation/placement_test.hpp"

namespace multimesh::decimation {

/// No triangle may turn by more than an angle in one collapse, nor become degenerate. Triangles without area
/// are not checked.
class NormalTurn final : public PlacementTest {
 public:
  /// `max_turn` in radians, below pi.
  explicit NormalTurn(double max_turn) : PlacementTest("normal turn"), min_cosine_(std::cos(max_turn)) {}
  bool allows(const PredictedStar& star, const CollapsePlan& plan) override;

 private:
  double min_cosine_;
};

/// No triangle may get an aspect ratio, longest edge over shortest height, above a limit, unless one of those
/// around the edge was already as bad. The equilateral triangle has 2 / sqrt(3).
class AspectRatio final : public PlacementTest {
 public:
  explicit AspectRatio(double limit) : PlacementTest("aspect ratio"), limit_(limit) {}
  bool allows(const PredictedStar& star, const CollapsePlan& plan) override;

 private:
  double limit_;
};

/// No triangle's normal may deviate by more than an angle from the normal of any input triangle that was
/// merged into it. Per triangle, a cone contains the normals of the input.
class NormalDeviation final : public PlacementTest {
 public:
  /// `limit` in radians. Cost: linear.
  NormalDeviation(const TriangleReader& reader, double limit);
  bool allows(const PredictedStar& star, const CollapsePlan& plan) override;
  void collapsed(const PredictedStar& star, const CollapsePlan& plan) override;

 private:
  struct Cone {
    Vec3 axis{0, 0, 0};
    double angle = -1;  ///< half the opening; below 0: empty
  };
  static Cone join(const Cone& x, const Cone& y);
  Cone cone_after(const PredictedStar& star, const PredictedStar::Face& face) const;

  double limit_;
  std::vector<Cone> cones_;  ///< per triangle of the surface
};

}  // namespace multimesh::decimation
