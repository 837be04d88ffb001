// SPDX-License-Identifier: BSD-3-Clause
// What a project that uses all of our libraries writes.
#include <cstdio>

#include "multimesh/error.hpp"
#include "multimesh/version.hpp"

int main() {
  try {
    throw multimesh::InputError(multimesh::version);
  } catch (const multimesh::InputError& error) {
    std::printf("multimesh %s\n", error.what());
  }
}
