// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <random>

#include "multimesh/algorithms/improvement/candidates.hpp"

namespace multimesh::test {

using namespace improvement;

/// \return a dart at the vertex that the new tetrahedra have in common; no_dart if refused
inline Dart do_it(Workspace& work, const Candidate& c) {
  switch (c.kind) {
    case Kind::split: {
      const Dart d = work.split(c.dart, c.place, c.strata);
      return d == no_dart ? d : work.mesh().reorder(d, exchange_ends);
    }
    case Kind::collapse:
      return work.collapse(c.dart);
    case Kind::edge_swap:
      return c.in_boundary ? work.swap_in_boundary(c.dart) : work.swap(c.dart);
    case Kind::face_swap:
      return work.swap_face(c.dart);
    case Kind::smoothing:
      return work.move(c.dart, c.place) ? c.dart : no_dart;
  }
  return no_dart;
}

/// Any candidate of a random kind at a random place that only has to leave all tetrahedra positive.
inline Candidate random_candidate(Workspace& work, Candidates& candidates, std::mt19937& random) {
  Demand demand;
  demand.enough = flat;
  Index t;
  do t = static_cast<Index>(random() % work.mesh().capacity(3));
  while (!work.is_live(t));
  const int i = static_cast<int>(random() % 4),
            j = static_cast<int>((i + 1 + static_cast<int>(random() % 3)) % 4);
  Candidate c;
  const Dart e = work.edge(t, i, j);
  switch (random() % 6) {
    case 0:
      candidates.split(e, demand, c);
      break;
    case 1:
    case 2:
      candidates.collapse(e, demand, c);
      break;
    case 3:
      candidates.edge_swap(e, demand, c);
      break;
    case 4:
      candidates.face_swap(e, demand, c);
      break;
    default:
      candidates.smoothing(e, demand, c);
  }
  return c;
}

}  // namespace multimesh::test
