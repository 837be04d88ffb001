// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace multimesh::tools {

inline void add(std::vector<std::string> more, std::vector<std::string>& warnings) {
  for (std::string& w : more) warnings.push_back(std::move(w));
}

}  // namespace multimesh::tools
