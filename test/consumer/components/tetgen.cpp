// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  return !multimesh::tetgen::delaunay({}).tets.corners.empty();
}
