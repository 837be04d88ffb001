// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/improvement/amips.hpp"

namespace multimesh::improvement {

// What a fixed surface allows at best: lower bounds of the AMIPS energy, attained by one tetrahedron each.
// All follow from energy = (sum l^2 / 2) / (6 sqrt(2) volume)^(2/3), l the lengths of the six edges, by
// minimizing over the corners that are free (docs/improve.md).

/// Of a tetrahedron over this triangle: (3 S / (4 A))^(2/3), S the sum of the squared lengths of its sides, A
/// its area. +infinity if it has none.
double least_amips_over(const Vec3& a, const Vec3& b, const Vec3& c);

/// Of a tetrahedron with a dihedral angle of at most this, radians; 3 from that of the regular one on.
double least_amips_at_dihedral(double angle);

/// Of a tetrahedron with a face that has an angle of at most this, radians; 3 from pi/3 on.
double least_amips_at_corner(double angle);

}  // namespace multimesh::improvement
