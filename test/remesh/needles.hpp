// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ostream>
#include <string>

#include "multimesh/domains/textured_triangles.hpp"

namespace multimesh::test {

/// How CAD programs triangulate a disk without a vertex of its own inside; `fan` has one in the middle.
enum class Cap { fan, corner, strip, halves };
inline constexpr Cap all_caps[] = {Cap::fan, Cap::corner, Cap::strip, Cap::halves};
std::string name(Cap cap);
/// Used by GoogleTest, which would otherwise print the bytes of a parameter.
inline void PrintTo(Cap cap, std::ostream* out) {
  *out << name(cap);
}

/// Surfaces of few long thin triangles: `segments` around, none along. Radius 1 at the bottom.
TexturedTriangles disk(int segments, Cap cap);
TexturedTriangles cone(int segments, double height, Cap cap);
TexturedTriangles cylinder(int segments, double height, double radius_on_top, Cap cap);
/// The middle of the fan is at (x, y).
TexturedTriangles eccentric_disk(int segments, double x, double y);
/// Two cones with one rim, their tips 1 above and below it.
TexturedTriangles lens(int segments);
/// A plate from (-1, -1) to (1, 1) with a round hole: all segments of its rim go to the nearest corner.
/// `thickness`: 0 for one sheet; else closed, with a wall around the hole.
TexturedTriangles drilled_plate(int segments, double x, double y, double radius, double thickness);
/// A box of 1 x 1 x thickness, cut into strips across.
TexturedTriangles plate(int segments, double thickness);

}  // namespace multimesh::test
