// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// The edges of all simplices, ends ascending, each once, in ascending order. In a file of second order the
/// point in the middle of edge i comes after the points of the soup, as number i. Cost: sorting
std::vector<std::array<std::uint32_t, 2>> edges_with_middles(const SimplexSoup& soup);

/// The soup in second order, for writers only: points in the middles of edges are appended, and a block has
/// 1, 3, 6 or 10 nodes per simplex instead of its corners, in Gmsh's order. Edges whose ends are linked as
/// periodic get linked middles.
/// \throw InputError naming `file` if there are too many points
SimplexSoup second_order(const SimplexSoup& soup, const std::string& file);

/// The number of nodes of each simplex of a block that is not empty.
inline std::size_t nodes_per_simplex(const SimplexSoup::Block& block) {
  return block.corners.size() / block.size();
}
inline std::span<const std::uint32_t> nodes_of(const SimplexSoup::Block& block, std::size_t simplex) {
  const std::size_t n = nodes_per_simplex(block);
  return std::span(block.corners).subspan(n * simplex, n);
}

}  // namespace multimesh::io
