// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace multimesh {

/// A permutation of up to four positions: an element of S4, in which S2 and S3 are the first 2 and 6 codes.
/// Applied to an ordering (v0,v1,v2,v3) it gives (v[p0],v[p1],v[p2],v[p3]).
struct Permutation {
  std::uint8_t code = 0;
  constexpr int operator[](int position) const noexcept;
  friend constexpr bool operator==(Permutation, Permutation) = default;
};

namespace detail {

using PermutationTable = std::array<std::array<std::uint8_t, 4>, 24>;

/// All of S4 by the largest moved position, then lexicographic: codes 0-1 are S2, 0-5 are S3.
constexpr PermutationTable make_permutations() {
  PermutationTable table{};
  std::size_t n = 0;
  for (int largest = 0; largest < 4; ++largest)
    for (std::uint8_t i = 0; i < 4; ++i)
      for (std::uint8_t j = 0; j < 4; ++j)
        for (std::uint8_t k = 0; k < 4; ++k) {
          if (i == j || i == k || j == k) continue;
          const auto l = static_cast<std::uint8_t>(6 - i - j - k);
          const int moved = l != 3 ? 3 : k != 2 ? 2 : j != 1 ? 1 : 0;
          if (moved == largest) table[n++] = {i, j, k, l};
        }
  return table;
}
inline constexpr PermutationTable permutations = make_permutations();

/// The position of the code of a permutation with these images; 2 bits each.
constexpr std::size_t images_key(int p0, int p1, int p2, int p3) {
  return static_cast<std::size_t>(p0 | p1 << 2 | p2 << 4 | p3 << 6);
}
inline constexpr auto codes_by_images = [] {
  std::array<std::uint8_t, 256> table{};
  for (std::uint8_t c = 0; c < 24; ++c) {
    const auto& p = permutations[c];
    table[images_key(p[0], p[1], p[2], p[3])] = c;
  }
  return table;
}();

}  // namespace detail

constexpr int Permutation::operator[](int position) const noexcept {
  return detail::permutations[code][static_cast<std::size_t>(position)];
}

/// The permutation with the images p0..p3, which are 0..3 in some order.
constexpr Permutation permutation(int p0, int p1, int p2 = 2, int p3 = 3) noexcept {
  return {detail::codes_by_images[detail::images_key(p0, p1, p2, p3)]};
}

/// First p, then q: applying the result equals applying p and then q.
constexpr Permutation then(Permutation p, Permutation q) noexcept {
  return permutation(p[q[0]], p[q[1]], p[q[2]], p[q[3]]);
}

constexpr Permutation inverse(Permutation p) noexcept {
  for (std::uint8_t c = 0; c < 24; ++c)
    if (then(p, {c}).code == 0) return {c};
  return {};
}

/// Whether it is a product of an even number of exchanges.
constexpr bool is_even(Permutation p) noexcept {
  int inversions = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = i + 1; j < 4; ++j) inversions += p[i] > p[j];
  return inversions % 2 == 0;
}

/// The effect of switch k on an ordering: positions k and k+1 are exchanged.
constexpr Permutation transposition(int k) noexcept {
  return k == 0 ? permutation(1, 0) : k == 1 ? permutation(0, 2, 1) : permutation(0, 1, 3, 2);
}

/// How many darts a facet has: 1, 2, 6 or 24.
constexpr std::uint8_t number_of_orders(int dimension) {
  return dimension == 0 ? 1 : dimension == 1 ? 2 : dimension == 2 ? 6 : 24;
}

// Of an edge dart (a, b, x): (b, a, x), (a, x, b) and (b, x, a).
inline constexpr Permutation exchange_ends = permutation(1, 0);
inline constexpr Permutation edge_ax = permutation(0, 2, 1);
inline constexpr Permutation edge_bx = permutation(1, 2, 0);

/// Of a dart (a, b, x1, ..): (a, x1, .., xk, b) and (b, x1, .., xk, a), the k-simplices on both sides of the
/// simplex a-b-x1-..-xk.
constexpr Permutation without_b(int k) noexcept {
  return k == 1 ? edge_ax : permutation(0, 2, 3, 1);
}
constexpr Permutation without_a(int k) noexcept {
  return k == 1 ? edge_bx : permutation(1, 2, 3, 0);
}

}  // namespace multimesh
