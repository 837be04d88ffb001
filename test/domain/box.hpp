// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "multimesh/domains/tet_domain.hpp"

namespace multimesh::test {

/// A box of unit cubes, six tetrahedra each, all positive; region(x, y, z) of the cube with that lowest
/// corner.
TaggedTetrahedra box(Index nx, Index ny, Index nz,
                     const std::function<TaggedTetrahedra::Tag(Index, Index, Index)>& region = {});

/// The point with these coordinates of such a box.
Index point_of(const TaggedTetrahedra& box, double x, double y, double z);

}  // namespace multimesh::test
