// SPDX-License-Identifier: BSD-3-Clause
// The core alone, without OpenMesh.
#include <cstdio>

#include "multimesh/error.hpp"
#include "multimesh/version.hpp"

int main() {
  try {
    throw multimesh::InputError(multimesh::version);
  } catch (const multimesh::InputError& error) {
    std::printf("multimesh core %s\n", error.what());
  }
}
