// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "oracle/complex.hpp"

/// What complex.hpp specifies, for dimension 3.
namespace multimesh::oracle {

/// Why distinct, non-degenerate tetrahedra are no manifold: a triangle in more than two, or a vertex whose
/// link is neither a sphere nor a disk. Empty for a manifold.
std::string solid_error(const Complex& c);

bool is_orientable_solid(const Complex& c);

/// For every component: Betti numbers, orientable, and the homeomorphism type of the boundary; sorted. Equal
/// for homeomorphic manifolds, but not only for those.
///
/// \pre a manifold
Signature solid_signature(const Complex& c);

}  // namespace multimesh::oracle
