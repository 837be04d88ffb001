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

/// Long thin triangles cut across, so that boxes around the pieces are about as large as these: a point
/// inside the box of a whole one is as a rule nowhere near it. The others are one piece each. In the order of
/// the triangles; at most three times as many, and 100,000 more. Cost: linear.
std::vector<Piece> pieces(const std::vector<Triangle>& triangles);

}  // namespace multimesh::spatial
