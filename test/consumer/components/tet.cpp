// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  const multimesh::tet::TetMesh mesh(multimesh::FacetList{3, 5, {0, 1, 2, 3, 1, 0, 2, 4}});
  return mesh.capacity(3) == 2 && mesh.capacity(0) == 5;
}
