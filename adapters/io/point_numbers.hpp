// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>

namespace multimesh::io {

/// The arbitrary numbers that a file gives its points, and our indices 0, 1, … of these points. Nothing is
/// stored as long as the numbers ascend by one.
class PointNumbers {
 public:
  /// Adds the next point. False when a point with this number exists already.
  bool add(std::uint64_t number) {
    if (count_ == 0) first_ = number;
    if (map_.empty() && number != first_ + count_)
      for (std::uint32_t i = 0; i < count_; ++i) map_.emplace(first_ + i, i);
    if (!map_.empty() || number != first_ + count_)
      if (!map_.emplace(number, count_).second) return false;
    ++count_;
    return true;
  }

  /// False when there is no such number.
  bool find(std::uint64_t number, std::uint32_t& index) const {
    if (map_.empty()) {
      index = static_cast<std::uint32_t>(number - first_);
      return number >= first_ && number - first_ < count_;
    }
    const auto at = map_.find(number);
    if (at == map_.end()) return false;
    index = at->second;
    return true;
  }

  std::uint32_t size() const { return count_; }

 private:
  std::uint64_t first_ = 0;
  std::uint32_t count_ = 0;
  std::unordered_map<std::uint64_t, std::uint32_t> map_;
};

}  // namespace multimesh::io
