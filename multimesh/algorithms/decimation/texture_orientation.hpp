// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/decimation/placement_test.hpp"

namespace multimesh::decimation {

/// No triangle of a texture may flip or lose its area. Flipped is judged against the chart: its orientation
/// is the sign of its total area when the test is made, so that mirrored charts decimate like others. A
/// triangle that is on the wrong side already may stay there or come right; one without area may stay so or
/// come right. A chart with much area on either side, as where halves of a symmetric model share their part
/// of the texture, has no wrong side: no triangle changes its own there, but one without area may get some.
/// Signs are exact, so this holds of triangles of any size.
class TextureOrientation final : public PlacementTest {
 public:
  /// Cost: linear.
  TextureOrientation(const TexturedSurface& surface, const TriangleReader& reader, std::size_t set);
  bool allows(const PredictedStar& star, const CollapsePlan& plan) override;
  std::size_t charts() const { return charts_.size(); }

 private:
  /// Areas are doubled here. Below these a triangle cannot be seen: per chart, since its neighbours may
  /// be far larger; and a triangle that is above the one of the whole texture may not fall below it.
  struct Chart {
    int sign = 0;
    double no_area = 0;
  };
  void find_charts(const Mesh& texture);
  void orient_charts(const TexturedSurface& surface, const TriangleReader& reader);
  bool keeps_sign(const PredictedStar::Face& face) const;

  std::size_t set_;
  double no_area_ = 0;
  std::vector<Chart> charts_;
  std::vector<Index> chart_of_;  ///< per triangle of the texture
};

}  // namespace multimesh::decimation
