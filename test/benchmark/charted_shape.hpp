// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "test/support/shapes.hpp"

namespace multimesh::bench {

/// A triangle mesh whose facets are assigned to charts.
struct ChartedShape {
  test::Shape shape;
  std::vector<std::uint8_t> chart;  ///< per facet
};

/// An icosahedron whose faces are cut into n x n triangles: 20 n^2. Eight charts, the octants.
ChartedShape charted_sphere(Index n);
/// 2nm triangles. Eight charts, 4 x 2 rectangles.
ChartedShape charted_torus(Index n, Index m);
/// 2nm triangles, with a boundary. Eight charts, 4 x 2 rectangles.
ChartedShape charted_grid(Index n, Index m);

/// The charts as a mesh of their own: facet i of `facets` lies over the vertices of facet i of `over`.
struct Texture {
  FacetList facets, over;
};
Texture texture_of(const ChartedShape& charted);

}  // namespace multimesh::bench
