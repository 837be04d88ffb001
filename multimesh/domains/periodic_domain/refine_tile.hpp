// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/periodic_domain/labelled_tile.hpp"

namespace multimesh {

/// Splits edges of a tile at their middles, each in all its copies at once, until the quotient has no loops
/// and no two edges with the same ends. New vertices are appended after the old ones. \return the number of
/// edges of the quotient that were split. `direct_rounds`: after this many rounds, only longest edges of
/// their facets are split. Cost: sorting, once per round; rounds are few
std::size_t refine_tile(LabelledTile& tile, int direct_rounds = 12);

}  // namespace multimesh
