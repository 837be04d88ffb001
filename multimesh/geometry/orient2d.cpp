// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/geometry/orient2d.hpp"

#include "multimesh/geometry/exact_sum.hpp"

namespace multimesh::detail {

int exact_orient2d(const double* a, const double* b, const double* c) {
  ExactSum<2> sum;
  const double* const p[] = {a, b, c, a};
  for (int i = 0; i < 3; ++i) {
    sum.add({p[i][0], p[i + 1][1]});
    sum.subtract({p[i][1], p[i + 1][0]});
  }
  return sum.sign();
}

}  // namespace multimesh::detail
