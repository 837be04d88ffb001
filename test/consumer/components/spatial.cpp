// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  using namespace multimesh::spatial;
  const TriangleTree tree({{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}});
  const auto found = tree.nearest({0.25, 0.25, 2});
  return found && found->squared_distance == 4;
}
