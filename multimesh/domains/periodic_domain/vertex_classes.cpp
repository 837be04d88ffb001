// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/vertex_classes.hpp"

#include <numeric>

namespace multimesh {

VertexClasses::VertexClasses(std::size_t n) : parent_(n), from_parent_(n) {
  std::iota(parent_.begin(), parent_.end(), Index{0});
}

Index VertexClasses::representative(Index v) {
  while (parent_[v] != v) {
    const Index p = parent_[v];
    from_parent_[v] = from_parent_[v] + from_parent_[p];  // that of a root is 0
    v = parent_[v] = parent_[p];
  }
  return v;
}

LatticeVector VertexClasses::offset(Index v) {
  LatticeVector sum{};
  for (; parent_[v] != v; v = parent_[v]) sum = sum + from_parent_[v];
  return sum;
}

bool VertexClasses::join(Index v, Index w, const LatticeVector& shift) {
  const Index p = representative(v), q = representative(w);
  const LatticeVector q_from_p = offset(v) + shift - offset(w);
  if (p == q) return q_from_p == LatticeVector{};
  if (p < q) {
    parent_[q] = p;
    from_parent_[q] = q_from_p;
  } else {
    parent_[p] = q;
    from_parent_[p] = LatticeVector{} - q_from_p;
  }
  return true;
}

}  // namespace multimesh
