// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  multimesh::TexturedTriangles one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles.push_back({{{0, -1}, {1, -1}, {2, -1}}});
  return multimesh::compare_surfaces(one, one, {.samples = 10}).hausdorff < 1e-12;
}
