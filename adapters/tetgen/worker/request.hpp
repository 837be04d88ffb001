// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "adapters/tetgen/worker_protocol.hpp"
#include "multimesh/dart.hpp"

namespace multimesh::tetgen::worker {

struct Request {
  RequestHeader header;
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<Index, 3>> triangles;
  std::vector<std::array<double, 3>> holes;
};

}  // namespace multimesh::tetgen::worker
