// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace multimesh {

/// The sign of det(b-a, c-a, d-a), exact for finite doubles: 1 if d sees the triangle (a,b,c) turn left,
/// which is the orientation of the tetrahedron (0,0,0), (1,0,0), (0,1,0), (0,0,1); -1; 0 if coplanar.
/// Arguments: 3 doubles each. Cost: some tens of operations, more only where the points are nearly coplanar.
/// Thread-safe. By CGAL's kernel of exact predicates (Bronnimann, Burnikel, Pion 2001).
int orient3d(const double* a, const double* b, const double* c, const double* d);

/// Whether three points of space, 3 doubles each, lie on one line; exact.
bool collinear(const double* a, const double* b, const double* c);

}  // namespace multimesh
