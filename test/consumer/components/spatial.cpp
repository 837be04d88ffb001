// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  using namespace multimesh::spatial;
  const Triangle triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  const TriangleTree tree(std::vector<Triangle>{triangle});
  const auto found = tree.nearest({0.25, 0.25, 2});
  return found && found->squared_distance == 4;
}
