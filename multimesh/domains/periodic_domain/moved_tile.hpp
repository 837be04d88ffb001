// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh {

/// The facets of a tile, each moved by a lattice vector, as lists.
class MovedTile {
 public:
  /// `by`: per facet slot of the tile, which must outlive this object.
  MovedTile(const PeriodicDomain& from, std::vector<LatticeVector> by);

  /// Its points and facets, with regions. Each copy of a vertex lies at the place of the first one, shifted.
  PeriodicTile lists() const;
  PeriodicOptions gluing() const;
  /// A copy of a simplex of the root: the lattice vector of its first vertex, and its vertices in the lists.
  struct Copy {
    LatticeVector offset;
    std::array<Index, 4> vertices;
  };
  /// All copies of the k-simplex of a dart of the root, the least offset first.
  std::vector<Copy> copies_of(Dart simplex, int k) const;

 private:
  LatticeVector offset(Dart d) const { return domain_.offsets()[tile_.vertex(d)] + by_[tile_.facet(d)]; }
  Index root_vertex(Dart d) const { return root_.vertex(domain_.tree().to_parent(domain_.tile(), d)); }
  Index number(Dart d) const;
  void find_keys();

  const PeriodicDomain& domain_;
  const Mesh& tile_;
  const Mesh& root_;
  std::vector<LatticeVector> by_;
  std::vector<std::vector<LatticeVector>> keys_;  // by root vertex: the offsets of its copies, ascending
  std::vector<Index> first_;                      // by root vertex: the number of its first copy
};

}  // namespace multimesh
