// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "oracle/simplex.hpp"

namespace multimesh::oracle {

/// Ranks of the homology groups with coefficients modulo 2, dimensions 0 to 3.
using Betti = std::array<int, 4>;

/// Of a complex, closed under faces; by elimination on its boundary matrices.
Betti betti(const SimplexSet& K);

/// Of the pair: the chains of K that are not in A. Where K is a manifold, these are by duality the ranks of
/// the cohomology of what is left of K without A (and of K without A and its boundary, if A contains it).
///
/// \pre both are closed under faces
Betti betti(const SimplexSet& K, const SimplexSet& A);

}  // namespace multimesh::oracle
