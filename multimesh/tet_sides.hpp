// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <span>
#include <utility>

#include "multimesh/cut.hpp"

namespace multimesh {

/// The edges of a tetrahedron by its corners, and their numbers.
inline constexpr std::uint8_t edge_corners[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
inline constexpr std::uint8_t edge_number[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};

/// Side 4 t + f of a list of tetrahedra is the face of tetrahedron t opposite its corner f. Its corners 4 t +
/// i, ordered so that their vertices, by `vertex_of(corner)`, ascend.
template <class VertexOf>
std::array<Index, 3> side_corners(Index side, const VertexOf& vertex_of) {
  std::array<Index, 3> c{};
  for (Index i = 0, n = 0; i < 4; ++i)
    if (i != side % 4) c[n++] = side - side % 4 + i;
  if (vertex_of(c[0]) > vertex_of(c[1])) std::swap(c[0], c[1]);
  if (vertex_of(c[1]) > vertex_of(c[2])) std::swap(c[1], c[2]);
  if (vertex_of(c[0]) > vertex_of(c[1])) std::swap(c[0], c[1]);
  return c;
}

/// For two sides with the same vertices, corners by ascending vertices: the permutation that takes local
/// corners of the first one's tetrahedron to those of the second one's.
constexpr Permutation across_sides(Index side, const std::array<Index, 3>& corners, Index other,
                                   const std::array<Index, 3>& other_corners) {
  std::array<int, 4> q{};
  q[side % 4] = static_cast<int>(other % 4);
  for (std::size_t i = 0; i < 3; ++i) q[corners[i] % 4] = static_cast<int>(other_corners[i] % 4);
  return permutation(q[0], q[1], q[2], q[3]);
}

/// Calls `visit` for each face of the tetrahedra with the sides that have its three vertices, ascending.
/// \pre corners are below tets.vertices. Cost: buckets by the least vertex, sorted
void for_each_face(const FacetList& tets, const std::function<void(std::span<const Index> sides)>& visit);

}  // namespace multimesh
