// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace multimesh::io {

/// Finds points at one place. With tolerance 0 these are points with equal coordinates, -0 and 0 being equal.
/// Otherwise the points are processed in their order: each one joins the nearest point within the tolerance
/// that joined no other, or stays. So every point is within the tolerance of the one that it joins, no two
/// points that stay are within it, and there are no chains: points that join one point are at most twice the
/// tolerance apart. Points with a coordinate that is not finite coincide with none. Cost: linear, expected.
/// \param tolerance distance in the units of the points, 0 or more
/// \return per point the index of the one that it joins, never a later one; its own if it stays
std::vector<std::uint32_t> coincident_points(std::span<const std::array<double, 3>> points,
                                             double tolerance = 0);

}  // namespace multimesh::io
