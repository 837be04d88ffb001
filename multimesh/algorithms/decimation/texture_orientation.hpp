// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/decimation/placement_test.hpp"
#include "multimesh/geometry/keeps_side.hpp"

namespace multimesh::decimation {

/// No triangle of a texture may flip or lose its area. Flipped means relative to the chart, whose orientation
/// is the sign of its total area when the test is made, so that mirrored charts decimate like others. A
/// triangle that is already on the wrong side may stay there or be corrected; one without area may stay so or
/// be corrected. A chart with much area on either side, for instance where halves of a symmetric model share
/// their part of the texture, has no wrong side: there no triangle changes its own, but one without area may
/// get some. Signs are exact, so this holds for triangles of any size.
class TextureOrientation final : public PlacementTest {
 public:
  /// Cost: linear.
  TextureOrientation(const TriangleReader& reader, std::size_t set);
  bool allows(const PredictedStar& star, const CollapsePlan& plan) override;
  std::size_t charts() const { return charts_.size(); }

 private:
  /// Triangles up to this doubled area are invisible: per chart, since its neighbours may be far larger.
  struct Chart {
    int sign = 0;
    double no_area = 0;
  };
  void find_charts(const Mesh& texture);
  void orient_charts(const TriangleReader& reader);
  bool keeps_sign(const PredictedStar::Face& face) const;

  std::size_t set_;
  KeepsSide keeps_;
  std::vector<Chart> charts_;
  std::vector<Index> chart_of_;  ///< per triangle of the texture
};

}  // namespace multimesh::decimation
