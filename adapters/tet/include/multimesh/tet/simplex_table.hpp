// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/tet/simplex_map.hpp"

namespace multimesh::tet {

/// Numbers on few of the edges (k = 1) or faces (k = 2) of a mesh, and per vertex the count of those around
/// it: most queries are answered by the counts, without a lookup in the map.
class SimplexTable {
 public:
  SimplexTable(int k, std::size_t vertices) : k_(k), around_(vertices, 0) {}

  int k() const noexcept { return k_; }
  const SimplexMap& map() const noexcept { return map_; }
  /// How many simplices with a number contain the vertex.
  Index around(Index v) const { return around_[v]; }
  void resize(std::size_t vertices) { around_.resize(vertices, 0); }

  /// The number of the first k+1 of these vertices; no_index if they have none.
  Index find(const Index* v) const {
    if (around_[v[0]] == 0 || around_[v[1]] == 0 || (k_ == 2 && around_[v[2]] == 0)) return no_index;
    return map_.find(simplex_key(v, k_));
  }

  /// no_index removes it. \return the previous number
  Index set(const SimplexKey& key, Index number) {
    const Index old = map_.set(key, number);
    if ((old == no_index) != (number == no_index))
      for (int i = 0; i <= k_; ++i)
        around_[key[static_cast<std::size_t>(i)]] += number == no_index ? ~0U : 1U;
    return old;
  }

  /// After compaction: vertex v is now place[v], number n is now numbers[n] (or still n, without them).
  void renumber(const std::vector<Index>& place, std::size_t vertices, const std::vector<Index>* numbers) {
    SimplexTable now(k_, vertices);
    map_.for_each([&](const SimplexKey& key, Index number) {
      Index v[3]{};
      for (std::size_t i = 0; i <= static_cast<std::size_t>(k_); ++i) v[i] = place[key[i]];
      now.set(simplex_key(v, k_), numbers ? (*numbers)[number] : number);
    });
    *this = std::move(now);
  }

 private:
  int k_;
  SimplexMap map_;
  std::vector<Index> around_;
};

}  // namespace multimesh::tet
