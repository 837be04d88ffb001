// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "multimesh/algorithms/improvement/counts.hpp"
#include "multimesh/refused_questions.hpp"
#include "multimesh/star_stamps.hpp"

namespace multimesh::improvement {

/// The refused candidates. Surfaces and curves have stamps of their own: what happens inside leaves them as
/// they are.
class Refusals {
 public:
  using Stamp = StarStamps::Stamp;

  /// \param tets approximate number of tetrahedra
  explicit Refusals(std::size_t tets) : questions_(8 * tets) {}

  const StarStamps& stars() const { return stars_; }
  /// Call when the stars of these vertices have changed; `surface`: also the surface and the curves at them.
  void change(const std::vector<Index>& vertices, bool surface) {
    stars_.change(vertices);
    if (surface) surface_.change(vertices);
  }

  /// Whether this operation on the edge (a,b) was refused in the present state of the star of a.
  bool knows(Kind kind, Index a, Index b) const {
    return questions_.knows(question(kind, a, b), stars_.of(a));
  }
  void note(Kind kind, Index a, Index b) { questions_.note(question(kind, a, b), stars_.of(a)); }
  /// Call when less is demanded of candidates.
  void forget() { questions_.forget(); }

  /// Whether the present surface around this vertex holds it: it can be neither moved nor merged.
  bool knows_held(Index v) const { return v < held_.size() && held_[v] != 0 && held_[v] == surface_.of(v); }
  void note_held(Index v) {
    if (v >= held_.size()) held_.resize(v + v / 2 + 1, 0);
    held_[v] = surface_.of(v);
  }

  /// See StarStamps::Trial.
  class Trial {
   public:
    explicit Trial(Refusals& of) : stars_(of.stars_), surface_(of.surface_) {}
    void keep() noexcept { stars_.keep(), surface_.keep(); }

   private:
    StarStamps::Trial stars_, surface_;
  };

 private:
  static std::uint64_t question(Kind kind, Index a, Index b) {
    return ((static_cast<std::uint64_t>(a) << 32U | b) << 3U) + static_cast<std::uint64_t>(kind);
  }

  StarStamps stars_, surface_;
  RefusedQuestions questions_;
  std::vector<Stamp> held_;  ///< the state of the surface in which the vertex was found held
};

}  // namespace multimesh::improvement
