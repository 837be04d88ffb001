// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "multimesh/star_stamps.hpp"

namespace multimesh {

/// Questions that were answered with no, each with the stamp of its neighbourhood at that time, so that none
/// is asked again until something there has changed. The table has a fixed size, in which later ones replace
/// earlier ones: a forgotten question is only asked once more.
class RefusedQuestions {
 public:
  using Stamp = StarStamps::Stamp;

  /// \param expected about how many there may be
  explicit RefusedQuestions(std::size_t expected) {
    constexpr std::size_t least = std::size_t{1} << 12U, most = std::size_t{1} << 20U;
    const std::size_t size = std::bit_ceil(std::clamp(expected, least, most));
    table_.resize(size);
    shift_ = 64U - static_cast<unsigned>(std::countr_zero(size));
  }

  /// `question`: any number below 2^64 - 1.
  bool knows(std::uint64_t question, Stamp stamp) const {
    const Entry& e = table_[place(question)];
    return e.key == question + 1 && e.stamp == stamp;
  }
  void note(std::uint64_t question, Stamp stamp) { table_[place(question)] = {question + 1, stamp}; }
  /// Call when less is demanded.
  void forget() { std::fill(table_.begin(), table_.end(), Entry{}); }

 private:
  struct Entry {
    std::uint64_t key = 0;
    Stamp stamp = 0;
  };
  std::size_t place(std::uint64_t question) const {
    return static_cast<std::size_t>(((question + 1) * 0x9E3779B97F4A7C15ULL) >> shift_);
  }

  std::vector<Entry> table_;
  unsigned shift_ = 0;
};

}  // namespace multimesh
