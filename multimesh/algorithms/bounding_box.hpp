// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace multimesh {

/// Length of the diagonal of the bounding box of some OpenMesh vectors; 0 if there are none.
template <class Vector>
double bounding_box_diagonal(const std::vector<Vector>& points) {
  if (points.empty()) return 0;
  Vector low = points.front(), high = low;
  for (const Vector& p : points) low.minimize(p), high.maximize(p);
  return (high - low).norm();
}

}  // namespace multimesh
