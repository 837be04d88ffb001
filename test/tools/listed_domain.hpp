// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "multimesh/io/simplex_soup.hpp"

namespace multimesh::tools::test {

/// n^3 cubes of six tetrahedra each around their diagonal, in the unit cube.
io::SimplexSoup kuhn_cube(std::uint32_t n);

/// Faces of the tetrahedra, edges of these, and points, any of them, with tags that are there or not, names,
/// and tags of several groups; regions in layers.
io::SimplexSoup random_domain(unsigned seed);

}  // namespace multimesh::tools::test
