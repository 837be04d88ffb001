// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "multimesh/cut.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::insertion {

using Edge = std::array<Index, 2>;

/// A part of a plane that becomes faces as a whole: a triangle, or neighbours that are exactly coplanar, turn
/// the same way and do not overlap.
struct Polygon {
  std::array<Index, 3> plane;    ///< three of its points that are not collinear, counter-clockwise
  std::vector<Edge> boundary;    ///< directed: the polygon is on the left
  std::vector<Index> triangles;  ///< of the input
};

/// What is inserted: polygons, and the segments that bound them.
struct Polygons {
  std::vector<Polygon> all;
  /// Unique, lower vertex first; the shortest first. Those of triangles without area are among them.
  std::vector<Edge> segments;
  std::vector<std::vector<Index>> beside;  ///< per segment: the polygons of which it is an edge
  std::size_t degenerate = 0;              ///< triangles without area
};

/// \param points finite; equal ones have one index. \param labels per triangle, or empty. \param merge
/// whether neighbours of one label are merged. Cost: sorting; exact tests in the plane between triangles of a
/// group whose boxes overlap
Polygons make_polygons(std::span<const Vec3> points, const FacetList& triangles,
                       std::span<const std::int32_t> labels, bool merge);

}  // namespace multimesh::insertion
