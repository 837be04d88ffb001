// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/geometry/vector.hpp"

namespace multimesh {

/// Length of the diagonal of the bounding box of some points; 0 if there are none.
template <std::size_t N>
double bounding_box_diagonal(const std::vector<Vec<N>>& points) {
  if (points.empty()) return 0;
  Vec<N> low = points.front(), high = low;
  for (const Vec<N>& p : points) low = min(low, p), high = max(high, p);
  return (high - low).norm();
}

}  // namespace multimesh
