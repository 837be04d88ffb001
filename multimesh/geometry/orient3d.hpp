// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/geometry/vector.hpp"

namespace multimesh {

/// The sign of det(b-a, c-a, d-a), exact for all finite doubles: 1 if d sees the triangle (a,b,c) turn left,
/// which is the orientation of the tetrahedron (0,0,0), (1,0,0), (0,1,0), (0,0,1); -1; 0 if coplanar.
/// Arguments: 3 doubles each. Cost: some tens of operations; about a microsecond where rounding could decide.
/// Thread-safe. Filter: Shewchuk, Adaptive precision floating-point arithmetic, 1997.
int orient3d(const double* a, const double* b, const double* c, const double* d);

/// The sign of det(b-a, c-a, n): 1 if the triangle (a,b,c) turns left for a viewer at the tip of n who looks
/// against n. Exact, as orient3d.
int orient_against(const double* n, const double* a, const double* b, const double* c);

/// Of a facet, by its dimension + 1 corners: a tetrahedron, or a triangle as seen against `normal`.
int orientation_of_facet(int dimension, const Vec3* corners, const Vec3& normal);

/// Whether three points of space, 3 doubles each, are collinear; exact.
bool collinear(const double* a, const double* b, const double* c);

}  // namespace multimesh
