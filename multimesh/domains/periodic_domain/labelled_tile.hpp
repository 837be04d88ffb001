// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "multimesh/cut.hpp"
#include "multimesh/domains/periodic_domain/lattice.hpp"

namespace multimesh {

/// A tile as plain lists; the vertices that are one modulo the lattice are known, but not glued yet.
struct LabelledTile {
  FacetList facets;
  std::vector<Index> input_facet;     ///< per facet: the input facet that it is part of
  std::vector<Vec3> point;            ///< per vertex, as are the following
  std::vector<Index> vertex_class;    ///< numbered from 0; no_index for vertices without facets
  std::vector<LatticeVector> offset;  ///< equal for all copies after subtraction of the lattice vectors
  Index classes = 0;
};

/// An edge of the quotient: ends by class, low one first, and the lattice vector from the copy of the first
/// end to that of the second one. Tile edges with equal QuotientEdges are copies of each other.
struct QuotientEdge {
  Index low, high;
  LatticeVector shift;
  bool is_loop() const { return low == high; }
  friend auto operator<=>(const QuotientEdge&, const QuotientEdge&) = default;
};

/// The edge of the quotient of which tile edge v-w is a copy; exchanges v and w if that leads from w to v.
inline QuotientEdge quotient_edge(const LabelledTile& tile, Index& v, Index& w) {
  const auto shift = [&] { return tile.offset[w] - tile.offset[v]; };
  if (tile.vertex_class[v] > tile.vertex_class[w] ||
      (tile.vertex_class[v] == tile.vertex_class[w] && shift() < LatticeVector{}))
    std::swap(v, w);
  return {tile.vertex_class[v], tile.vertex_class[w], shift()};
}

}  // namespace multimesh
