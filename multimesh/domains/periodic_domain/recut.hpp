// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh {

/// A tile cut elsewhere: facets are moved by lattice vectors until the old sides lie inside, where algorithms
/// reach them; and moved back afterwards. What a tile lists is carried along, with one of its copies.
///
// clang-format off
///      +---+---+        +---+---+
///      | c | d |        | b | a |        The cross in the middle of the second one is the outline of the
///      +---+---+   ->   +---+---+        first.
///      | a | b |        | d | c |
///      +---+---+        +---+---+
// clang-format on
///
/// Moving rounds coordinates once, by an ulp of the tile's size. \pre the root did not have to be cut where
/// it is not manifold
class RecutTile {
 public:
  /// Facets whose middle lies less than `at` from the least corner of the tile, in units of the periods, are
  /// moved by a period. `drop`: without what is listed in the old sides. \throw InputError if the moved tile
  /// cannot be glued
  RecutTile(const PeriodicDomain& home, const Vec3& at, bool drop);

  PeriodicDomain& domain() { return domain_; }
  /// The tile in its current state, cut along faces near the sides that it once had.
  PeriodicDomain back() const;
  /// Listed simplices that were dropped.
  std::size_t dropped() const { return dropped_; }

 private:
  PeriodicDomain moved(const PeriodicDomain& home, const Vec3& at, bool drop);

  std::size_t dropped_ = 0;
  Vec3 origin_;  // the least coordinates of the old tile in units of the periods
  PeriodicDomain domain_;
};

}  // namespace multimesh
