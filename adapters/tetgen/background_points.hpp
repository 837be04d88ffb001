// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/tetgen/delaunay.hpp"

namespace multimesh::tetgen {

/// A box with axis-parallel edges.
struct Box {
  Point low{}, high{};
};

/// How many boxes there are for the same points: those of attempt 0, 1, ...
inline constexpr unsigned boxes = 6;

/// The box around the points, with the margin. \throw InputError, UsageError as delaunay()
Box background_box(std::span<const Point> points, const DelaunayOptions& options, unsigned attempt = 0);

/// The points to be added: the corners of the box, and the nodes of the grid. None of them equals one of the
/// input points. \throw InputError, UsageError as delaunay()
std::vector<Point> background_points(std::span<const Point> points, const Box& box,
                                     const DelaunayOptions& options);

/// Per point the first one that is equal; 0.0 and -0.0 are equal.
std::vector<Index> first_equal(std::span<const Point> points);

}  // namespace multimesh::tetgen
