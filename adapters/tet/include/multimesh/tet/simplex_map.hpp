// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh::tet {

/// An edge or a triangle by its vertices, ascending; an edge has no_index last.
using SimplexKey = std::array<Index, 3>;

/// The key of the first k+1 of these vertices; k is 1 or 2.
inline SimplexKey simplex_key(const Index* v, int k) {
  SimplexKey key{v[0], v[1], k == 2 ? v[2] : no_index};
  if (key[0] > key[1]) std::swap(key[0], key[1]);
  if (key[1] > key[2]) std::swap(key[1], key[2]);
  if (key[0] > key[1]) std::swap(key[0], key[1]);
  return key;
}

/// A number per edge or triangle, for few of them: open addressing with linear probing. Erasing shifts the
/// following entries back, so there are no tombstones. Cost: constant, expected; 16 bytes per slot, a third
/// of the slots are free.
class SimplexMap {
 public:
  /// The number of a simplex, or no_index.
  Index find(const SimplexKey& key) const {
    if (slots_.empty()) return no_index;
    for (std::size_t i = home(key);; i = (i + 1) & mask_) {
      if (slots_[i].value == no_index || slots_[i].key == key) return slots_[i].value;
    }
  }

  /// Sets the number, or removes it (no_index). \return the previous one
  Index set(const SimplexKey& key, Index value) {
    return value == no_index ? erase(key) : insert(key, value);
  }

  std::size_t size() const noexcept { return size_; }

  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const Slot& s : slots_)
      if (s.value != no_index) visit(s.key, s.value);
  }

 private:
  struct Slot {
    SimplexKey key{};
    Index value = no_index;
  };

  std::size_t home(const SimplexKey& key) const {
    std::uint64_t h = key[0] * 0x9E3779B97F4A7C15U;
    h = (h ^ (h >> 29) ^ key[1]) * 0xBF58476D1CE4E5B9U;
    h = (h ^ (h >> 32) ^ key[2]) * 0x94D049BB133111EBU;
    return static_cast<std::size_t>(h ^ (h >> 31)) & mask_;
  }

  Index insert(const SimplexKey& key, Index value) {
    if (3 * (size_ + 1) > 2 * slots_.size()) grow();
    std::size_t i = home(key);
    while (slots_[i].value != no_index && slots_[i].key != key) i = (i + 1) & mask_;
    const Index old = slots_[i].value;
    size_ += old == no_index;
    slots_[i] = {key, value};
    return old;
  }

  Index erase(const SimplexKey& key) {
    if (slots_.empty()) return no_index;
    std::size_t i = home(key);
    while (slots_[i].value != no_index && slots_[i].key != key) i = (i + 1) & mask_;
    const Index old = slots_[i].value;
    if (old == no_index) return old;
    --size_;
    // An entry may move back to the hole unless its home slot lies after it.
    for (std::size_t j = (i + 1) & mask_; slots_[j].value != no_index; j = (j + 1) & mask_) {
      const std::size_t from_home = (j - home(slots_[j].key)) & mask_;
      if (from_home < ((j - i) & mask_)) continue;
      slots_[i] = slots_[j];
      i = j;
    }
    slots_[i].value = no_index;
    return old;
  }

  void grow() {
    std::vector<Slot> old(std::max<std::size_t>(16, 2 * slots_.size()));
    old.swap(slots_);
    mask_ = slots_.size() - 1;
    size_ = 0;
    for (const Slot& s : old)
      if (s.value != no_index) insert(s.key, s.value);
  }

  std::vector<Slot> slots_;
  std::size_t mask_ = 0, size_ = 0;
};

}  // namespace multimesh::tet
