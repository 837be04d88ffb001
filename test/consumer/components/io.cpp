// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"

bool works() {
  return multimesh::io::parse_obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "a.obj").face_count() == 1;
}
