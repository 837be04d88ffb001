// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>
#include <string>

#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/keeps_orientation.hpp"

namespace multimesh::test {

/// Random operations on all meshes of a periodic tile, from a seed: splits, collapses, swaps of edges and
/// faces, and moves.
class PeriodicStorm {
 public:
  /// `shape`: whether to refuse operations that would invert a facet of the tile.
  PeriodicStorm(PeriodicDomain& domain, unsigned seed, bool shape);

  void step();
  /// What is wrong: validate(), copies that are no lattice vector apart, inverted facets if `shape`.
  std::string fault() const;

  std::size_t done = 0, refused = 0;
  std::size_t moved_with_copies[9] = {};  ///< [n]: moves of a vertex with n copies

 private:
  Dart random_dart(NodeId n);
  bool move(NodeId n, Dart d);

  PeriodicDomain& domain_;
  Propagation operations_;
  KeepsOrientation positive_;
  bool shape_;
  std::mt19937 random_;
  std::size_t facets_at_start_ = 0, live_ = 0, steps_ = 0;
  double step_size_ = 0;
};

}  // namespace multimesh::test
