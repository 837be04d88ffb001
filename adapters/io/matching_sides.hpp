// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace multimesh::io {

/// The axes along which points may be a periodic tile: the points on the two sides of their bounding box are
/// equal except for that coordinate, exactly, and are more than the corners of a box. Cost: n log n in the
/// points on these sides
/// \return a subset of "x", "y", "z"
std::vector<std::string> axes_with_matching_sides(std::span<const std::array<double, 3>> points);

}  // namespace multimesh::io
