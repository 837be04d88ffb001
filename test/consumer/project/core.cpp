// SPDX-License-Identifier: BSD-3-Clause
// The core alone, without OpenMesh.
#include <cstdio>

#include "multimesh/error.hpp"
#include "multimesh/version.hpp"

#if !MULTIMESH_VERSION_AT_LEAST(0, 1, 0) || MULTIMESH_VERSION_AT_LEAST(99, 0, 0)
#error "the version of the installed headers"
#endif

int main() {
  try {
    throw multimesh::InputError(multimesh::version);
  } catch (const multimesh::InputError& error) {
    std::printf("multimesh core %s\n", error.what());
  }
}
