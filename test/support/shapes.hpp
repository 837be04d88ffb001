// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <random>
#include <vector>

#include "multimesh/cut.hpp"

namespace multimesh::test {

using Point = std::array<double, 3>;

/// A triangle mesh with a position per vertex.
struct Shape {
  FacetList facets;
  std::vector<Point> points;
};

/// (n+1) x (m+1) vertices, 2nm triangles; vertex (i,j) has the index i*(m+1)+j.
Shape grid(Index n, Index m);
/// A grid bent to a ring in its first direction: two boundary loops. n >= 3.
Shape annulus(Index n, Index m);
/// n x m vertices, 2nm triangles; vertex (i,j) has the index i*m+j. n, m >= 3.
Shape torus(Index n, Index m);
/// An octahedron, subdivided `levels` times: 8 * 4^levels triangles.
Shape sphere(int levels);
/// The triangle fan of n triangles around vertex 0.
Shape disk(Index n);

/// The square tile of torus(n, m): grid(n, m), and its facets by the vertices of the torus.
struct Tile {
  Shape grid;
  FacetList over;
};
Tile tile_of_torus(Index n, Index m);

/// Vertices of each edge, lower one first, sorted.
std::vector<std::array<Index, 2>> edges_of(const FacetList& triangles);

}  // namespace multimesh::test
