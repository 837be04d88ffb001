// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "multimesh/permutation.hpp"

namespace multimesh::tet {

/// Products of permutations by code: product[q][p][i] = q[p[i]]. A dart is a permutation p of the local
/// corners; with a glue permutation q on the left it is the same ordering in the neighbour, with a
/// re-ordering r on the right, product[p][r], another ordering in the same tetrahedron.
inline constexpr auto product = [] {
  std::array<std::array<std::uint8_t, 32>, 32> table{};
  std::uint8_t code_of[256] = {};
  const auto key = [](int a, int b, int c, int d) {
    return static_cast<std::size_t>(a | b << 2 | c << 4 | d << 6);
  };
  for (std::uint8_t c = 0; c < 24; ++c) {
    const Permutation p{c};
    code_of[key(p[0], p[1], p[2], p[3])] = c;
  }
  for (std::uint8_t q = 0; q < 24; ++q)
    for (std::uint8_t p = 0; p < 24; ++p) {
      const Permutation a{q}, b{p};
      table[q][p] = code_of[key(a[b[0]], a[b[1]], a[b[2]], a[b[3]])];
    }
  return table;
}();

inline constexpr auto inverse_code = [] {
  std::array<std::uint8_t, 32> table{};
  for (std::uint8_t p = 0; p < 24; ++p)
    for (std::uint8_t q = 0; q < 24; ++q)
      if (product[q][p] == 0) table[p] = q;
  return table;
}();

/// exchange[i][j]: local corners i and j change places.
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

/// Whether it is an even number of exchanges; gluing two tetrahedra of the same orientation is odd.
constexpr bool is_even(Permutation p) {
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) inversions += p[i] > p[j];
  return inversions % 2 == 0;
}

/// Number of the edge between local corners i and j.
inline constexpr std::uint8_t edge_number[4][4] = {{0, 0, 1, 2}, {0, 0, 3, 4}, {1, 3, 0, 5}, {2, 4, 5, 0}};
inline constexpr std::uint8_t edge_corners[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};

}  // namespace multimesh::tet
