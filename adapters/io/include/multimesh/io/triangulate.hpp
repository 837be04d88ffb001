// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "multimesh/io/polygon_soup.hpp"

namespace multimesh::io {

/// Triangles with the corners of the polygons from which they were made.
struct TriangleSoup {
  std::vector<std::array<PolygonSoup::Corner, 3>> triangles;
  std::vector<std::uint32_t> polygon;  ///< face of the polygon soup, per triangle; ascending
};

/// Cuts every polygon of n corners into n-2 triangles of its orientation; each edge of the polygon is an edge
/// of exactly one of them. Never fails. Quads are cut along the diagonal that leaves no inverted triangle,
/// the shorter one if both do; larger ones by clipping ears in the plane of their vector area (Newell),
/// including concave ones and ones with holes joined by a doubled edge. Some triangles of a polygon that
/// crosses itself or has no area are inverted or flat. A triangle can name a vertex twice only if its polygon
/// does. Cost: O(1) for triangles and quads, O(n log n) in practice for n corners.
///
///     d-----c        d-----c
///     |     |        |   / |
///     |     |   ->   | /   |
///     a-----b        a-----b
TriangleSoup triangulate(const PolygonSoup& soup);

}  // namespace multimesh::io
