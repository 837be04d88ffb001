// SPDX-License-Identifier: BSD-3-Clause
#include "tools/warnings.hpp"

#include <cmath>
#include <sstream>

namespace multimesh::tools {

void warn_of_sizes(const char* what, const RegionSizes& before, const RegionSizes& after, double much,
                   const std::string& remedy, std::vector<std::string>& warnings) {
  for (const auto& [region, size] : before) {
    const auto now = after.find(region);
    const double change = now == after.end() ? -1 : now->second / size - 1;
    if (std::abs(change) <= much) continue;
    std::ostringstream text;
    text.precision(2);
    text << "the " << what << " of region " << region << " has changed by " << 100 * change << " %; "
         << remedy << " keeps it better";
    warnings.push_back(text.str());
  }
}

}  // namespace multimesh::tools
