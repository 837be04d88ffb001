// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <vector>

#include "multimesh/domains/textured_surface.hpp"

namespace multimesh::test {

/// A triangle complex, counted only from the vertices of its triangles; possibly not manifold.
struct ComplexFacts {
  long components = 0;        ///< joined across edges
  long euler = 0;             ///< V - E + F
  long boundary = 0;          ///< connected pieces of the edges with one triangle
  long crowded_edges = 0;     ///< edges with three or more triangles
  long pinched_vertices = 0;  ///< vertices whose link is not connected
  friend bool operator==(const ComplexFacts&, const ComplexFacts&) = default;
};

/// Edges with two triangles that are not one edge of the texture.
struct SeamFacts {
  long curves = 0, ends = 0, junctions = 0;
  friend bool operator==(const SeamFacts&, const SeamFacts&) = default;
};

/// What decimation must keep, judged without any code of the library. A vertex of the texture is a position
/// with a value of the texture coordinates.
struct Facts {
  ComplexFacts surface, texture;
  SeamFacts seams;
  friend bool operator==(const Facts&, const Facts&) = default;
};
std::ostream& operator<<(std::ostream& out, const Facts& f);

Facts facts(const TexturedTriangles& surface);

/// Triangles of `out` that are flipped or without area in the texture although their source in `in` was not.
/// Flipped is judged by the sign of the total area of the source's chart.
std::size_t newly_flipped(const TexturedTriangles& in, const TexturedTriangles& out,
                          const std::vector<Index>& source);

}  // namespace multimesh::test
