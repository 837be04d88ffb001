// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "oracle/complex.hpp"

namespace multimesh::oracle {

/// An edge of a 2-complex and the facets on it: how many, and the first two with the corner opposite.
struct EdgeUse {
  Simplex edge;
  int count = 0;
  std::array<int, 2> facet{-1, -1};
  std::array<int, 2> corner{-1, -1};
};

/// All edges, sorted, each with its facets.
///
/// \pre dim 2, no degenerate facets
std::vector<EdgeUse> edge_uses(const Complex& c);

/// A surface as triangles glued side to side. Vertices are what the glued sides make of the corners, so this
/// is always a 2-manifold, in which cut edges lie twice and pinched vertices several times.
struct Gluing {
  std::vector<Facet> facets;                  ///< vertices of the complex
  std::vector<std::array<int, 3>> neighbour;  ///< facet glued to the side opposite corner i; -1 for none
  std::vector<Facet> corner;                  ///< vertex of the glued surface at corner i, 0..corners-1
  int corners = 0;
};

/// Glues facets along the edges that lie in exactly two facets and are not in `cuts`.
Gluing glue(const Complex& c, const SimplexSet& cuts = {});
Gluing glue(const Complex& c, const std::vector<EdgeUse>& uses, const SimplexSet& cuts);

/// The type of a connected compact surface.
struct Region {
  int euler = 0;
  int loops = 0;
  bool orientable = true;

  friend auto operator<=>(const Region&, const Region&) = default;
};

/// The components of a glued surface.
struct Regions {
  std::vector<Region> types;
  std::vector<int> of_facet;  ///< component of each facet
};

Regions regions(const Gluing& g);

/// (euler, loops, orientable) of all regions, sorted.
Signature signature(std::vector<Region> types);

/// Lengths of the boundary loops of the glued surface, ascending.
std::vector<int> boundary_loops(const Gluing& g);

/// For each vertex of the complex that is several vertices of the glued surface: the vertex, ascending.
std::vector<int> pinched_vertices(const Gluing& g);

/// (complex vertex, glued vertex) of all corners: sorted, without duplicates.
std::vector<std::array<int, 2>> vertex_copies(const Gluing& g);

}  // namespace multimesh::oracle
