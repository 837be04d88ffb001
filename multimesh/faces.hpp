// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "multimesh/permutation.hpp"

namespace multimesh {

namespace detail {

/// The permutations that keep positions 0..k and bring each choice of j-k of the positions k+1..d to k+1..j.
/// Applied to a dart of a d-facet, they give its j-faces around the k-simplex, each once.
struct FaceList {
  std::array<Permutation, 6> permutations{};
  std::size_t size = 0;
};

constexpr FaceList make_faces(int d, int j, int k) {
  FaceList list;
  for (unsigned chosen = 0; chosen < 16; ++chosen) {
    int p[4] = {0, 1, 2, 3}, n = 0;
    bool valid = true;
    for (int i = 0; i < 4; ++i) {
      const bool in = (chosen >> i) & 1U;
      if (in) p[n++] = i;
      if ((i <= k && !in) || (i > d && in)) valid = false;
    }
    if (!valid || n != j + 1) continue;
    for (int i = 0; i < 4; ++i)
      if (!((chosen >> i) & 1U)) p[n++] = i;
    list.permutations[list.size++] = permutation(p[0], p[1], p[2], p[3]);
  }
  return list;
}

// Indexed by [d][j][k+1]; k = -1 asks for all j-faces of the facet.
constexpr auto make_all_faces() {
  std::array<std::array<std::array<FaceList, 5>, 4>, 4> all{};
  for (int d = 0; d <= 3; ++d)
    for (int j = 0; j <= d; ++j)
      for (int k = -1; k <= j; ++k)
        all[static_cast<std::size_t>(d)][static_cast<std::size_t>(j)][static_cast<std::size_t>(k + 1)] =
            make_faces(d, j, k);
  return all;
}
inline constexpr auto all_faces = make_all_faces();

}  // namespace detail

/// Reorderings of a d-facet's dart that give each j-face (0 <= j <= d) containing the k-simplex of the dart
/// exactly once, as the first j+1 vertices; the first k+1 stay. k = -1: all j-faces of the facet.
constexpr std::span<const Permutation> faces_around(int d, int j, int k) {
  const auto& list = detail::all_faces[static_cast<std::size_t>(d)][static_cast<std::size_t>(j)]
                                      [static_cast<std::size_t>(k + 1)];
  return {list.permutations.data(), list.size};
}

}  // namespace multimesh
