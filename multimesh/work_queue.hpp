// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// A priority queue of simplices of one dimension, by index: lowest cost first, ties by index (so that runs
/// are reproducible). Lazy: a new cost supersedes the old entry, which stays in the queue and is skipped when
/// it comes up. Whoever changes the mesh pushes what is new or different.
///
/// Only the entries up to a boundary form a heap, small enough for the cache. The others wait unsorted until
/// the heap is empty; then about a sixteenth is moved into it. Amortized cost of an entry: sixteen sequential
/// reads and a part of the small heap. (One heap of all misses the cache at each level.)
class WorkQueue {
 public:
  struct Entry {
    double cost;
    Index simplex;
    std::uint32_t stamp;
  };

  /// Reserves room for simplices up to this index, so that stamps need no later allocation.
  void reserve(std::size_t simplices) {
    stamps_.resize(std::max(simplices, stamps_.size()), 0);
    far_.reserve(2 * simplices);
  }

  void push(Index simplex, double cost) {
    if (simplex >= stamps_.size()) stamps_.resize(simplex + simplex / 2 + 1, 0);
    const Entry entry{cost, simplex, ++stamps_[simplex]};
    if (later(entry, boundary_)) {
      far_.push_back(entry);
    } else {
      near_.push_back(entry);
      std::push_heap(near_.begin(), near_.end(), later);
    }
  }

  void erase(Index simplex) {
    if (simplex < stamps_.size()) ++stamps_[simplex];
  }

  /// Pops the simplex of least cost; false if there is none. The caller checks that it is still alive.
  bool pop(Entry& least) {
    for (;;) {
      while (!near_.empty()) {
        std::pop_heap(near_.begin(), near_.end(), later);
        least = near_.back();
        near_.pop_back();
        if (is_current(least)) return true;
      }
      if (far_.empty()) return false;
      refill();
    }
  }

 private:
  static bool later(const Entry& x, const Entry& y) {
    return x.cost > y.cost || (x.cost == y.cost && x.simplex > y.simplex);
  }
  bool is_current(const Entry& e) const { return stamps_[e.simplex] == e.stamp; }

  void refill() {
    boundary_ = next_boundary();
    const auto due =
        std::partition(far_.begin(), far_.end(), [&](const Entry& e) { return later(e, boundary_); });
    std::copy_if(due, far_.end(), std::back_inserter(near_), [&](const Entry& e) { return is_current(e); });
    far_.erase(due, far_.end());
    std::make_heap(near_.begin(), near_.end(), later);
  }

  /// An entry above about 1/16 of the far ones, estimated by a sample; the last one if they are few.
  Entry next_boundary() {
    const auto earlier = [](const Entry& x, const Entry& y) { return later(y, x); };
    if (far_.size() <= 4096) return *std::max_element(far_.begin(), far_.end(), earlier);
    std::array<Entry, 512> sample;
    for (Entry& e : sample) e = far_[random_() % far_.size()];
    std::nth_element(sample.begin(), sample.begin() + sample.size() / 16, sample.end(), earlier);
    return sample[sample.size() / 16];
  }

  // All of near_ are at most boundary_, all of far_ are above it.
  std::vector<Entry> near_, far_;
  Entry boundary_{-std::numeric_limits<double>::infinity(), 0, 0};
  std::vector<std::uint32_t> stamps_;
  std::minstd_rand random_;  // with a fixed seed
};

}  // namespace multimesh
