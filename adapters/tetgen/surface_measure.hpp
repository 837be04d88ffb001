// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "adapters/tetgen/tetrahedralize.hpp"

namespace multimesh::tetgen {

using LongVector = std::array<long double, 3>;

long double dot(const LongVector& a, const LongVector& b);

/// Twice the area of a triangle, along its normal.
LongVector area_vector(std::span<const Point> points, const std::array<Index, 3>& corners);

/// The volume of a tetrahedron, with its sign.
long double volume_of(std::span<const Point> points, const std::array<Index, 4>& corners);

/// A bound of the rounding error of volume_of().
long double least_volume(std::span<const Point> points, const std::array<Index, 4>& corners);

/// The volume that triangles enclose, \#F x 3 corners; regions count as often as the surface goes round them.
long double enclosed_volume(std::span<const Point> points, std::span<const Index> corners);

/// The first triangle whose faces, which follow each other, do not have its area and direction in sum;
/// no_index: none.
Index first_uncovered(std::span<const Point> points, std::span<const Index> corners,
                      std::span<const SurfaceFace> faces);

}  // namespace multimesh::tetgen
