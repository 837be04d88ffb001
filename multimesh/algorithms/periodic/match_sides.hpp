// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "multimesh/algorithms/periodic/vertex_classes.hpp"

namespace multimesh {

/// Joins vertices that lie a period vector apart. Where the tile is a box, its sides must match completely:
/// its extent along a period is then that period; a tile that is longer (jagged sides, hexagons) is matched
/// where it matches. `used`: the vertices of facets, the others are left alone. Cost: linear, by hashing.
/// \throw InputError naming the vertex that has no partner or more than one, or the axis along which nothing
///        matches
void match_sides(const Lattice& lattice, std::span<const Eigen::Vector3d> points, std::span<const Index> used,
                 double tolerance, VertexClasses& classes);

/// Joins given pairs; the vertices of each must lie a lattice vector apart. \throw InputError naming the pair
void match_pairs(const Lattice& lattice, std::span<const Eigen::Vector3d> points,
                 std::span<const std::array<Index, 2>> pairs, double tolerance, VertexClasses& classes);

}  // namespace multimesh
