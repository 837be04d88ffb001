// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include "test/core/bridge.hpp"
#include "test/core/mesh_cases.hpp"

namespace multimesh::test {

void shake(Mesh& mesh, unsigned seed, int operations) {
  std::mt19937 random(seed);
  SplitRecord split;
  CollapseRecord collapse;
  for (int i = 0; i < operations; ++i) {
    const DartBuffer darts = all_darts(mesh);
    const Dart d = darts[random() % darts.size()];
    switch (random() % 3) {
      case 0:
        mesh.split_edge(d, split);
        break;
      case 1:
        if (mesh.link_condition(d)) mesh.collapse_edge(d, collapse);
        break;
      default:
        if (mesh.can_flip(d)) mesh.flip_edge(d);
    }
  }
  mesh.forget();
}

}  // namespace multimesh::test
