// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/geometry/vector.hpp"

namespace multimesh::improvement {

// The best that a fixed surface allows: lower bounds of the AMIPS energy, each attained by one tetrahedron.
// All follow from energy = (sum l^2 / 2) / (6 sqrt(2) volume)^(2/3), l the lengths of the six edges, by
// minimizing over the free corners (docs/improve.md).

/// For a tetrahedron over this triangle: (3 S / (4 A))^(2/3), S the sum of the squared lengths of its sides,
/// A its area. +infinity if it has no area.
double least_amips_over(const Vec3& a, const Vec3& b, const Vec3& c);

/// For a tetrahedron with a dihedral angle of at most this, radians; 3 from the regular one's on.
double least_amips_at_dihedral(double angle);

/// For a tetrahedron with a face that has an angle of at most this, radians; 3 from pi/3 on.
double least_amips_at_corner(double angle);

}  // namespace multimesh::improvement
