// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "test/algorithms/collapse_driver.hpp"
#include "test/algorithms/rich_surface.hpp"

namespace multimesh::test {

/// A surface on which costs of collapses are tried.
struct CostCase {
  std::string name;
  TexturedTriangles input;
  TexturedSurfaceOptions options = {};
};

inline void PrintTo(const CostCase& c, std::ostream* out) {
  *out << c.name;
}

std::vector<CostCase> cost_cases();

/// Without the memory of the input's planes, which is in single precision and has a test of its own.
DecimateOptions memoryless();

/// All edges that are left, from both ends in turn.
std::vector<Dart> edges_of(const Mesh& mesh);

}  // namespace multimesh::test
