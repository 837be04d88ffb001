// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace multimesh::oracle {

/// Union-find over 0..n-1; the representative of a set is its smallest member.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t n) : count_(n) {
    parent_.reserve(n);
    for (std::size_t i = 0; i < n; ++i) parent_.push_back(i);
  }

  std::size_t find(std::size_t i) const {
    while (parent_[i] != i) i = parent_[i];
    return i;
  }

  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i == j) return;
    if (i < j) {
      parent_[j] = i;
    } else {
      parent_[i] = j;
    }
    --count_;
  }

  /// Number of sets.
  std::size_t count() const { return count_; }

 private:
  std::vector<std::size_t> parent_;
  std::size_t count_;
};

}  // namespace multimesh::oracle
