// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "multimesh/cut.hpp"

namespace multimesh::tetgen {

using Point = std::array<double, 3>;

/// Tetrahedra as plain data. For a tetrahedron (a, b, c, d), det(b - a, c - a, d - a) > 0: seen from d, the
/// corners a, b, c run counter-clockwise.
struct TetrahedraList {
  std::vector<Point> points;                      ///< \#V x 3
  FacetList tets{.dimension = 3, .corners = {}};  ///< \#T x 4, indices into points
};

/// The faces of a tetrahedron, face k opposite corner k, oriented so that their normals point outwards.
inline constexpr std::array<std::array<std::size_t, 3>, 4> outward_faces{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace multimesh::tetgen
