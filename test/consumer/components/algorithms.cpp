// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  multimesh::TexturedTriangles fan;
  fan.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  for (int i = 0; i < 4; ++i) fan.triangles.push_back({{{i, -1}, {(i + 1) % 4, -1}, {4, -1}}});
  multimesh::TexturedSurface surface(fan);
  return multimesh::decimate(surface, {.faces = 2}).faces_after == 2;
}
