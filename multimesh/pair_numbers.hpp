// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// Numbers unordered pairs of indices by their first appearance: edges by their vertices, for instance. Each
/// pair is stored in the list of the rarer of its two indices, so that lists are short even at the apex of a
/// large fan: looking up all edges of a mesh takes linear time (Chiba, Nishizeki 1985). Neither sorts nor
/// hashes. 8 bytes per index and per pair.
class PairNumbers {
 public:
  /// All indices must be below `indices`.
  explicit PairNumbers(std::size_t indices) : lists_(indices) {}
  PairNumbers(std::size_t indices, std::span<const Index> expected) : PairNumbers(indices) {
    for (const Index i : expected) expect(i);
  }

  /// Call before the first pair, once per (or in proportion to) the pairs in which the index will occur. Only
  /// speed depends on it.
  void expect(Index i) { ++lists_[i].expected; }
  void reserve(std::size_t pairs) { pairs_.reserve(pairs); }

  /// The pair's number; a new pair gets the previous size().
  Index operator()(Index v, Index w) {
    const Index of_v = lists_[v].expected, of_w = lists_[w].expected;
    const bool v_is_rarer = of_v < of_w || (of_v == of_w && v < w);
    List& list = lists_[v_is_rarer ? v : w];
    const Index other = v_is_rarer ? w : v;
    for (Index p = list.last; p != no_index; p = pairs_[p].previous)
      if (pairs_[p].other == other) return p;
    pairs_.push_back({other, list.last});
    return list.last = size() - 1;
  }

  Index size() const noexcept { return static_cast<Index>(pairs_.size()); }

 private:
  struct List {
    Index expected = 0;
    Index last = no_index;
  };
  struct Pair {
    Index other;
    Index previous;  // in the same list
  };
  std::vector<List> lists_;
  std::vector<Pair> pairs_;
};

}  // namespace multimesh
