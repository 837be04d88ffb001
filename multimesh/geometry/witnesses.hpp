// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh::spatial {

/// Stores for each triangle of the input which triangles of the current surface are near it, a few at most,
/// and the inverse. Initially there are none. Triangles of the surface may have greater indices than those of
/// the input.
class Witnesses {
 public:
  /// With three, decimation ended with a third more triangles; more than six made no difference.
  static constexpr std::size_t most = 6;
  /// Pairwise different; no_index in unused places.
  using Set = std::array<Index, most>;

  explicit Witnesses(std::size_t triangles) : first_(triangles, no_index), slots_(most * triangles) {}

  Set of(Index input) const {
    Set set;
    for (std::size_t i = 0; i < most; ++i) set[i] = slots_[most * input + i].witness;
    return set;
  }
  void set(Index input, const Set& witnesses) {
    for (std::size_t i = 0; i < most; ++i) {
      const auto s = static_cast<Index>(most * input + i);
      unlink(s);
      link(s, witnesses[i]);
    }
  }
  /// Whether holds(input) for all triangles of the input of which this one is a witness.
  template <class Predicate>
  bool all_of(Index witness, Predicate holds) const {
    if (witness >= first_.size()) return true;
    for (Index s = first_[witness]; s != no_index; s = slots_[s].next)
      if (!holds(static_cast<Index>(s / most))) return false;
    return true;
  }

 private:
  struct Slot {
    Index witness = no_index;
    Index next = no_index, previous = no_index;  ///< in the list of the witness
  };

  void link(Index s, Index witness) {
    slots_[s] = {witness, no_index, no_index};
    if (witness == no_index) return;
    if (witness >= first_.size()) first_.resize(witness + witness / 2 + 1, no_index);
    Index& first = first_[witness];
    if (first != no_index) slots_[first].previous = s;
    slots_[s].next = first;
    first = s;
  }
  void unlink(Index s) {
    const Slot& slot = slots_[s];
    if (slot.witness == no_index) return;
    (slot.previous == no_index ? first_[slot.witness] : slots_[slot.previous].next) = slot.next;
    if (slot.next != no_index) slots_[slot.next].previous = slot.previous;
  }

  std::vector<Index> first_;  ///< slot of each witness
  std::vector<Slot> slots_;   ///< `most` per triangle of the input
};

}  // namespace multimesh::spatial
