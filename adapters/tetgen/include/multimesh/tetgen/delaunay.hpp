// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::tetgen {

struct DelaunayOptions {
  /// How far the box reaches beyond the points, relative to the diagonal of their bounding box; up to 1.41
  /// times as far, not the same on all sides. In [0, 100]. With 0 the points themselves must have an extent
  /// along each axis.
  double box_margin = 0.1;
  /// Adds the nodes of a grid that fills the box; a length, the upper bound of its steps along the axes. 0:
  /// no grid, only the eight corners of the box are added.
  double grid_spacing = 0;
  /// Grid nodes nearer than this to an input point, or to one of the triangles, are left out; relative to
  /// grid_spacing; in [0, 1].
  double grid_clearance = 0.5;
  FacetList triangles{2, 0, {}};  ///< of the points
};

/// The Delaunay tetrahedra of a box with points in it. The input's points come first, in its order, followed
/// by those that the box and the grid added. All are corners of tetrahedra, except repeated input points.
struct DelaunayMesh : TetrahedraList {
  std::vector<Index> merged_to;  ///< per input point: the first one that is equal, possibly itself
};

/// Delaunay tetrahedralization of the points in a box, by TetGen in a process of its own. The result depends
/// only on the input. Cost: 10 us per random point, 30 on a grid, where the predicates are exact; 1 KB.
/// Without points the box is the unit cube. \throw InputError if a coordinate is not finite (naming the
/// point), if the points are flat and box_margin is 0, or extend over less than 1e-40 or more than 1e40, or
/// are too many, the grid's included. \throw UsageError if an option is out of its range; std::runtime_error
/// if the process fails
DelaunayMesh delaunay(std::span<const Point> points, const DelaunayOptions& options = {});

}  // namespace multimesh::tetgen
