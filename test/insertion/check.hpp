// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/algorithms/insert.hpp"

namespace multimesh::test {

/// Delaunay tetrahedra of a box around the points, with the nodes of a grid.
BackgroundMesh background_of(const TriangleSoup& soup, double grid_spacing = 0);

/// What is wrong with an arrangement that was not rounded, in words; by fractions, from its lists alone:
/// areas of polygons, volumes, planes, and whether faces are faces of the tetrahedra.
std::vector<std::string> faults(const TriangleSoup& soup, const BackgroundMesh& background,
                                const Arrangement& arrangement);

}  // namespace multimesh::test
