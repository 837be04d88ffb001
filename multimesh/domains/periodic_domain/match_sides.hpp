// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/domains/periodic_domain/vertex_classes.hpp"

namespace multimesh {

/// The lattice vectors that can lead from one vertex of a tile to another: sums and differences of periods as
/// long as the tile, one of each pair v, -v. \throw InputError if the tile is shorter than one of its
/// periods, or many times as long
std::vector<LatticeVector> vectors_within(const Lattice& lattice, std::span<const Vec3> points,
                                          std::span<const Index> used, double tolerance);

/// Joins vertices that lie a lattice vector apart, one of `vectors`. Where the tile lies between two
/// neighbouring planes of the lattice, as a box does, each vertex on one of them must have a partner on the
/// other; a tile that is longer (jagged sides, hexagons) is matched where it matches. `used`: the vertices of
/// facets; the others are ignored. Cost: linear, by hashing. \throw InputError naming the vertex that has no
/// partner or more than one, or the axis along which nothing matches
void match_sides(const Lattice& lattice, std::span<const Vec3> points, std::span<const Index> used,
                 std::span<const LatticeVector> vectors, double tolerance, VertexClasses& classes);

/// Joins given pairs; the vertices of each must lie a lattice vector apart. \throw InputError naming the pair
void match_pairs(const Lattice& lattice, std::span<const Vec3> points,
                 std::span<const std::array<Index, 2>> pairs, double tolerance, VertexClasses& classes);

}  // namespace multimesh
