// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::tetgen {

using LongVector = std::array<long double, 3>;

long double dot(const LongVector& a, const LongVector& b);

/// Twice the area of a triangle, along its normal.
LongVector area_vector(std::span<const Point> points, const std::array<Index, 3>& corners);

/// The volume of a tetrahedron, with its sign.
long double volume_of(std::span<const Point> points, const std::array<Index, 4>& corners);

/// A bound of the rounding error of volume_of().
long double least_volume(std::span<const Point> points, const std::array<Index, 4>& corners);

/// Whether the corners are not collinear, up to the rounding of this test: the height over the longest edge
/// is above the least one.
bool has_area(std::span<const Point> points, const std::array<Index, 3>& corners,
              long double least_height = 0);

/// The signed volume of the tetrahedron between a triangle and a point: positive if the normal points away
/// from the point. Its sum over all triangles around a region is the volume that they enclose.
long double cone_volume(std::span<const Point> points, const std::array<Index, 3>& corners,
                        const Point& origin);

/// The length of the diagonal of the points' bounding box.
long double diagonal(std::span<const Point> points);

/// Whether the parts together have the area and direction of the triangle. `diagonal` is the extent of all
/// points, which determines their rounding.
bool is_covered(std::span<const Point> points, const std::array<Index, 3>& triangle,
                std::span<const std::array<Index, 3>> parts, long double diagonal);

}  // namespace multimesh::tetgen
