// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/geometry/closest_point.hpp"

namespace multimesh::spatial {

/// A part of a triangle.
struct Piece {
  Triangle triangle;
  Index facet;
};

/// Cuts long thin triangles across, so that boxes around the pieces are about as large as the pieces: a point
/// inside the box of a whole one is usually nowhere near it. Other triangles are one piece each. In the order
/// of the triangles; at most three times as many, plus 100,000. Cost: linear.
std::vector<Piece> pieces(const std::vector<Triangle>& triangles);

}  // namespace multimesh::spatial
