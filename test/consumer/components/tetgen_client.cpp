// SPDX-License-Identifier: BSD-3-Clause
#include "all_headers.hpp"
#include "multimesh/error.hpp"

bool works() try {
  multimesh::tetgen::tetrahedralize({}, {2, 0, {}});
  return false;
} catch (const multimesh::InputError&) {
  return true;  // nothing to fill
}
