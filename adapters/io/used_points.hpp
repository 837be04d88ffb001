// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

/// Removes points that no simplex names, such as those of higher order that readers keep; the others keep
/// their order. Also removes periodic pairs that lose a point. Cost: linear.
/// \return #points before: the new index of each, 4294967295 where it is removed
std::vector<std::uint32_t> remove_unused_points(SimplexSoup& soup);

}  // namespace multimesh::io
