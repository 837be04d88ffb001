// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace multimesh::tools {

inline void add(std::vector<std::string> more, std::vector<std::string>& warnings) {
  for (std::string& w : more) warnings.push_back(std::move(w));
}

/// Volumes or areas, by region.
using RegionSizes = std::map<std::int32_t, double>;
/// Share of the size of a region above which a change by decimation or of a surface causes a warning.
constexpr double much_of_size = 0.005;
/// A sentence for each region whose size has changed by more than `much` of it. `remedy`: what keeps it
/// better.
void warn_of_sizes(const char* what, const RegionSizes& before, const RegionSizes& after, double much,
                   const std::string& remedy, std::vector<std::string>& warnings);

}  // namespace multimesh::tools
