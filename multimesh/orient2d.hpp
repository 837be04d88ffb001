// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace multimesh {

/// The sign of det(b-a, c-a), exact for all finite doubles: 1 if (a,b,c) turns left, -1, 0 if the three lie
/// on one line. Arguments: 2 doubles each. Cost: some operations; about 100 ns where rounding could decide.
/// Thread-safe. Filter: Shewchuk, Adaptive precision floating-point arithmetic, 1997.
int orient2d(const double* a, const double* b, const double* c);

}  // namespace multimesh
