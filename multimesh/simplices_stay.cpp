// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/simplices_stay.hpp"

#include <algorithm>

namespace multimesh {

bool SimplicesStay::before(const Event& event) {
  return std::ranges::none_of(event.copies.all(), [&](const Copy& c) { return changes(event, c); });
}

// In a collapse, facets around the end that keeps its place stay, except those that die.
bool SimplicesStay::changes(const Event& event, const Copy& c) {
  const Mesh& mesh = event.tree.mesh(c.node);
  switch (event.operation) {
    case Operation::split:
    case Operation::flip:
      return any_around(mesh, c.node, c.dart, 1);
    case Operation::collapse:
      return any_around(mesh, c.node, c.dart, 1) || (event.t > 0 && any_around(mesh, c.node, c.dart, 0)) ||
             (event.t < 1 && any_around(mesh, c.node, mesh.reorder(c.dart, exchange_ends), 0));
    case Operation::relocate:
      return any_around(mesh, c.node, c.dart, 0);
  }
  return false;
}

bool SimplicesStay::any_around(const Mesh& mesh, NodeId n, Dart d, int k) {
  mesh.star(d, k, star_);
  return std::ranges::any_of(star_, [&](Dart f) { return stays_(n, mesh.facet(f)); });
}

}  // namespace multimesh
