// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace multimesh {

namespace detail {

/// For cases where rounding could decide.
int exact_orient2d(const double* a, const double* b, const double* c);

}  // namespace detail

/// The sign of det(b-a, c-a), exact for all finite doubles: 1 if (a,b,c) turns left, -1 if right, 0 if
/// collinear. Arguments: 2 doubles each. Cost: a few operations; about 100 ns where rounding could decide.
/// Thread-safe. Filter: Shewchuk, Adaptive precision floating-point arithmetic, 1997.
inline int orient2d(const double* a, const double* b, const double* c) {
  constexpr double rounding = 3.3306690738754716e-16;  // (3 + 16 e) e, e = 2^-53
  constexpr double underflow = 1e-300;  // far above what products lose below the normal doubles
  const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
  const double det = left - right, bound = rounding * (std::abs(left) + std::abs(right)) + underflow;
  if (std::isfinite(bound) && std::abs(det) > bound) return det > 0 ? 1 : -1;
  return detail::exact_orient2d(a, b, c);
}

}  // namespace multimesh
