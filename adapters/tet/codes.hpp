// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "multimesh/permutation.hpp"

namespace multimesh::tet {

/// Products of permutations by code: product[q][p][i] = q[p[i]]. A dart is a permutation p of the local
/// corners. With a glue permutation q on the left it is the same ordering in the neighbour; with a reordering
/// r on the right, product[p][r], it is another ordering in the same tetrahedron.
inline constexpr auto product = [] {
  std::array<std::array<std::uint8_t, 32>, 32> table{};
  for (std::uint8_t q = 0; q < 24; ++q)
    for (std::uint8_t p = 0; p < 24; ++p) table[q][p] = then({q}, {p}).code;
  return table;
}();

inline constexpr auto inverse_code = [] {
  std::array<std::uint8_t, 32> table{};
  for (std::uint8_t p = 0; p < 24; ++p) table[p] = inverse({p}).code;
  return table;
}();

/// exchange[i][j]: exchanges local corners i and j.
inline constexpr auto exchange = [] {
  std::array<std::array<std::uint8_t, 4>, 4> table{};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      int p[4] = {0, 1, 2, 3};
      p[i] = j, p[j] = i;
      table[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          permutation(p[0], p[1], p[2], p[3]).code;
    }
  return table;
}();

}  // namespace multimesh::tet
