// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include "multimesh/algorithms/improve.hpp"
#include "tools/surface_json.hpp"

namespace multimesh::tools {

inline Json to_json(const TetQuality& q) {
  return {{"tetrahedra", q.tets},
          {"vertices", q.vertices},
          {"max_amips", q.max_amips},
          {"mean_amips", q.mean_amips},
          {"above_target", q.above_target}};
}

}  // namespace multimesh::tools
