// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::test {

/// A surface as TetGen's adapter takes it, oriented outwards.
struct ClosedSurface {
  std::vector<tetgen::Point> points;
  FacetList triangles;
};

ClosedSurface cube(double size = 1);
/// An octahedron refined `levels` times, on the sphere: 8 * 4^levels triangles.
ClosedSurface sphere(double radius, int levels, const tetgen::Point& center = {});
/// A torus round the z axis with around * across quads, halved.
ClosedSurface torus(double radius, double thickness, Index around, Index across);
ClosedSurface reversed(ClosedSurface surface);
/// Both, side by side in one list.
ClosedSurface joined(const ClosedSurface& a, const ClosedSurface& b);

}  // namespace multimesh::test
