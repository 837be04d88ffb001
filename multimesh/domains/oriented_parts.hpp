// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/cut.hpp"

namespace multimesh {

/// Per facet, the least vertex of its part; parts are joined by vertices. Cost: nearly linear
std::vector<Index> parts_of(const FacetList& facets);

/// Per facet, whether the sizes (signed volumes or areas) of its part sum up to less than 0.
std::vector<bool> in_negative_part(const std::vector<Index>& part, const std::vector<double>& sizes);

}  // namespace multimesh
