// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::io {

bool names_a_point_twice(std::span<const std::uint32_t> corners);
/// \pre one entry per simplex
void remove_simplices(SimplexSoup::Block& block, const std::vector<bool>& removed);

/// Makes one simplex of those with the same points, in any order: Gmsh 2.2 lists an element once per group.
/// The first one stays, with the flags of all; if they have several tags, with the tag of a tag set, a new
/// tag. Simplices listed again with the same tag are counted in notes.doubled.
/// \pre every index is in range. Cost: linear, unless many simplices share their lowest point
void unite_repeated_simplices(SimplexSoup& soup);

}  // namespace multimesh::io
