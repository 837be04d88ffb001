// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  multimesh::TexturedTriangles one;
  one.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles.push_back({{{0, -1}, {1, -1}, {2, -1}}});
  multimesh::TexturedSurface surface(one);
  multimesh::RemeshOptions options;
  options.length = 0.3;
  return multimesh::remesh(surface, options).splits > 0;
}
