// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace multimesh {

/// Hash of a small array of words (mixing of splitmix64: Steele, Lea, Flood 2014).
struct ArrayHash {
  template <std::size_t n>
  std::size_t operator()(const std::array<std::uint64_t, n>& words) const noexcept {
    std::uint64_t h = 0;
    for (const std::uint64_t w : words) {
      h = (h ^ w) + 0x9e3779b97f4a7c15ULL;
      h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ULL;
      h = (h ^ (h >> 27)) * 0x94d049bb133111ebULL;
      h ^= h >> 31;
    }
    return static_cast<std::size_t>(h);
  }
};

}  // namespace multimesh
