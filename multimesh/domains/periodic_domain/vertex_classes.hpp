// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/domains/periodic_domain/lattice.hpp"

namespace multimesh {

/// Vertices that are one vertex modulo a lattice, with the lattice vector between them: union-find with
/// weights. The representative of a class is its least member.
class VertexClasses {
 public:
  explicit VertexClasses(std::size_t n);

  /// Declares that w lies at v + shift. \return false if that contradicts earlier declarations
  [[nodiscard]] bool join(Index v, Index w, const LatticeVector& shift);
  Index representative(Index v);
  /// The shift to v from its representative.
  LatticeVector offset(Index v);

 private:
  std::vector<Index> parent_;
  std::vector<LatticeVector> from_parent_;
};

}  // namespace multimesh
