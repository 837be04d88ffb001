// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/orient2d.hpp"

#include <cmath>

#include "multimesh/exact_sum.hpp"

namespace multimesh {

namespace {

int exact(const double* a, const double* b, const double* c) {
  detail::ExactSum<2> sum;
  const double* const p[] = {a, b, c, a};
  for (int i = 0; i < 3; ++i) {
    sum.add({p[i][0], p[i + 1][1]});
    sum.subtract({p[i][1], p[i + 1][0]});
  }
  return sum.sign();
}

}  // namespace

int orient2d(const double* a, const double* b, const double* c) {
  constexpr double rounding = 3.3306690738754716e-16;  // (3 + 16 e) e, e = 2^-53
  constexpr double underflow = 1e-300;  // far above what products lose below the normal doubles
  const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
  const double det = left - right, bound = rounding * (std::abs(left) + std::abs(right)) + underflow;
  if (std::isfinite(bound) && std::abs(det) > bound) return det > 0 ? 1 : -1;
  return exact(a, b, c);
}

}  // namespace multimesh
