// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>

#include "test/support/shapes.hpp"

/// Tetrahedral meshes, consistently oriented.
namespace multimesh::test {

using Tetrahedron = std::array<Index, 4>;

/// These tetrahedra, turned where orientation asks for it; positions are arbitrary but distinct.
Shape tetrahedra(std::initializer_list<Tetrahedron> list);

Shape single_tet();           ///< 0123
Shape one_ear();              ///< 0123, 0234
Shape two_ears();             ///< and 0135
Shape three_incident_tets();  ///< 0123, 0234, 2345: all at 2-3
Shape three_cycle();          ///< all three around 0-1: rim 2, 3, 4
Shape four_cycle();           ///< all four around 0-1: rim 2, 3, 4, 5
/// All six around 2-3, rim 0, 4, 5, 7, 6, 1: tetrahedra 0123, 0234, 2345, 2357, 2367, 1236.
Shape six_cycle();

/// Kuhn's grid: n x m x l cubes of six tetrahedra; vertex (i,j,k) has the index (i (m+1) + j) (l+1) + k.
Shape box(Index n, Index m, Index l);
/// box(n, n, n) with opposite sides identified: 6 n^3 tetrahedra, closed. n >= 3; n >= 4 for any collapse.
Shape torus3(Index n);
/// A surface times an interval of n steps, 3n tetrahedra per triangle: of a sphere a shell, of an annulus a
/// solid torus. Vertex v of layer l has the index l * #vertices + v.
Shape layers(const Shape& surface, Index n);
/// A vertex, the last one, joined to a surface: of a sphere a ball.
Shape cone(const Shape& surface);

/// The cube of torus3(n): box(n, n, n), and its facets by the vertices of the torus.
Tile tile_of_torus3(Index n);

}  // namespace multimesh::test
