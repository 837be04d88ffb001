// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// A priority queue of edges, lowest cost first, ties by index (so that runs are reproducible). Lazy: a new
/// cost supersedes the old entry, which stays in the heap and is skipped when it comes up.
class EdgeQueue {
 public:
  struct Entry {
    double cost;
    Index edge;
    std::uint32_t stamp;
  };

  /// Room for edges up to this index, without a later allocation of stamps.
  void reserve(std::size_t edges) {
    stamps_.resize(std::max(edges, stamps_.size()), 0);
    heap_.reserve(2 * edges);
  }

  void push(Index edge, double cost) {
    if (edge >= stamps_.size()) stamps_.resize(edge + edge / 2 + 1, 0);
    heap_.push_back({cost, edge, ++stamps_[edge]});
    std::push_heap(heap_.begin(), heap_.end(), later);
  }
  /// Collects entries without order; call heapify() before the first pop.
  void push_unordered(Index edge, double cost) {
    if (edge >= stamps_.size()) stamps_.resize(edge + edge / 2 + 1, 0);
    heap_.push_back({cost, edge, ++stamps_[edge]});
  }
  void heapify() { std::make_heap(heap_.begin(), heap_.end(), later); }

  void erase(Index edge) {
    if (edge < stamps_.size()) ++stamps_[edge];
  }

  /// Takes the edge of least cost; false if there is none. The caller checks that the edge is still alive.
  bool pop(Entry& least) {
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end(), later);
      least = heap_.back();
      heap_.pop_back();
      if (stamps_[least.edge] == least.stamp) return true;
    }
    return false;
  }

 private:
  static bool later(const Entry& x, const Entry& y) {
    return x.cost > y.cost || (x.cost == y.cost && x.edge > y.edge);
  }
  std::vector<Entry> heap_;
  std::vector<std::uint32_t> stamps_;
};

}  // namespace multimesh
