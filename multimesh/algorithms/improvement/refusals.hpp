// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "multimesh/algorithms/improvement/counts.hpp"

namespace multimesh::improvement {

/// Remembers refused candidates, so that none is tried again until something around it has changed. Each
/// vertex has a number for the current state of its star; when undoing a trial restores a state, it also
/// restores the old number. Candidates are stored in a table of fixed size in which later ones replace
/// earlier ones: a forgotten candidate is only tried once more.
class Refusals {
 public:
  using State = std::uint32_t;

  /// \param tets approximate number of tetrahedra
  explicit Refusals(std::size_t tets);

  State state(Index v) const { return of(Layer::star, v); }
  /// Call when the stars of these vertices have changed; `surface`: also the surface and the curves at them.
  void change(const std::vector<Index>& vertices, bool surface);

  /// Whether this operation on the edge (a,b) was refused in the present state of the star of a.
  bool knows(Kind kind, Index a, Index b) const {
    const Entry& e = table_[place(kind, a, b)];
    return e.key == key(kind, a, b) && e.state == state(a);
  }
  void note(Kind kind, Index a, Index b) { table_[place(kind, a, b)] = {key(kind, a, b), state(a)}; }
  /// Call when less is demanded of candidates.
  void forget() { std::fill(table_.begin(), table_.end(), Entry{}); }

  /// Whether the present surface around this vertex holds it: it can be neither moved nor merged.
  bool knows_held(Index v) const {
    return v < held_.size() && held_[v] != 0 && held_[v] == of(Layer::surface, v);
  }
  void note_held(Index v) {
    if (v >= held_.size()) held_.resize(v + v / 2 + 1, 0);
    held_[v] = of(Layer::surface, v);
  }

  // --- trials, which may be nested
  /// \return what end_trial() needs
  std::size_t begin_trial();
  void end_trial(std::size_t begin, bool undone);

 private:
  struct Entry {
    std::uint64_t key = 0;
    State state = 0;
  };
  enum class Layer : std::uint8_t { star, surface };
  struct Change {
    Layer layer;
    Index vertex;
    State before;
  };
  State of(Layer layer, Index v) const {
    const std::vector<State>& states = states_[static_cast<std::size_t>(layer)];
    return v < states.size() ? states[v] : 0;
  }
  void change(Layer layer, Index v);
  static std::uint64_t key(Kind kind, Index a, Index b) {
    return ((static_cast<std::uint64_t>(a) << 32U | b) << 3U) + static_cast<std::uint64_t>(kind) + 1;
  }
  std::size_t place(Kind kind, Index a, Index b) const {
    return static_cast<std::size_t>((key(kind, a, b) * 0x9E3779B97F4A7C15ULL) >> shift_);
  }

  std::array<std::vector<State>, 2> states_;  ///< per layer and vertex
  std::vector<State> held_;                   ///< the state of the surface in which the vertex was found held
  State last_ = 0;
  std::vector<Entry> table_;
  unsigned shift_ = 0;
  std::vector<Change> log_;  ///< of the trials in progress
  int depth_ = 0;
};

}  // namespace multimesh::improvement
