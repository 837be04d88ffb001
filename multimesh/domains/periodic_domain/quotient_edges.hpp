// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "multimesh/domains/periodic_domain/labelled_tile.hpp"

namespace multimesh {

/// The edges of a tile's facets as edges of the quotient.
///
/// The quotient is a proper simplicial complex if no edge is a loop, no two edges have the same ends, and no
/// two facets have the same vertices. Then simplices of all dimensions are determined by their vertices: if
/// two have the same vertices, their edges differ by lattice vectors that are equal for all ends, so one is
/// the other, shifted.
class QuotientEdges {
 public:
  /// Cost: sorting.
  explicit QuotientEdges(const LabelledTile& tile);

  Index size() const { return static_cast<Index>(edges_.size()); }
  const QuotientEdge& operator[](Index e) const { return edges_[e]; }
  /// The edges of a facet, in the order of its pairs of corners (0,1), (0,2), (1,2), (0,3), (1,3), (2,3).
  std::span<const Index> of_facet(std::size_t f) const { return {of_facet_.data() + f * n_, n_}; }
  /// The ends of a copy of an edge in the tile, starting at its first end.
  std::array<Index, 2> tile_edge(Index e) const { return tile_edge_[e]; }
  /// Edges are sorted so that edges with the same ends, and loops, are contiguous: the range of those with
  /// the ends of e.
  std::array<Index, 2> parallel(Index e) const;

 private:
  std::size_t n_;  // per facet
  std::vector<QuotientEdge> edges_;
  std::vector<std::array<Index, 2>> tile_edge_;
  std::vector<Index> of_facet_;
};

/// Per vertex of the tile: whether it is one of several copies.
std::vector<bool> with_copies(const LabelledTile& tile);

/// The periods that are too short for the quotient to be a simplicial complex, naming edges; or nothing.
std::optional<std::string> too_short(const LabelledTile& tile);

/// Two facets of the quotient with the same vertices, by their input facets, or nothing.
std::optional<std::array<Index, 2>> double_facet(const LabelledTile& tile);

}  // namespace multimesh
