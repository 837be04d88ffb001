// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  multimesh::TaggedTetrahedra input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.tets = {3, 4, {0, 1, 2, 3}};
  const multimesh::TetDomain domain(input);
  // With points go vectors: their products need no other header.
  const auto& p = domain.points();
  return dot(cross(p[1] - p[0], p[2] - p[0]), p[3] - p[0]) > 0;
}
