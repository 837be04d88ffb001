// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/tetgen/tetrahedra.hpp"

namespace multimesh::tetgen {

/// Sorts three corners; true if that is an even permutation.
bool sort_corners(std::array<Index, 3>& corners);

/// A triangle of the input that covers a facet.
struct FacetSource {
  Index triangle = no_index;
  bool reversed = false;  ///< it is oriented against the facet
};

/// The triangles of an input as constraints: each once, all with area, meeting in whole edges.
struct Facets {
  std::vector<Index> corners;        ///< \#F x 3; oriented as their first source
  std::vector<FacetSource> sources;  ///< facet by facet, each by ascending triangle
  std::vector<Index> begin = {0};    ///< \#F+1 offsets into sources
  std::size_t collapsed = 0;         ///< triangles that name a point twice, left out
  std::size_t flat = 0;              ///< triangles with collinear corners, left out
  double least_height = 0;           ///< below which they count as flat
  std::size_t split = 0;             ///< triangles that were cut where a flat one had joined them to others

  Index size() const { return static_cast<Index>(begin.size()) - 1; }
  std::array<Index, 3> facet(Index f) const {
    const std::size_t first = 3 * std::size_t{f};
    return {corners[first], corners[first + 1], corners[first + 2]};
  }
  std::span<const FacetSource> sources_of(Index f) const {
    return std::span(sources).subspan(begin[f], begin[f + 1] - begin[f]);
  }
};

/// The two sides of a facet. `no_index`: no region, outside.
struct Sides {
  Index behind = no_index, before = no_index;  ///< regions; the normal points to `before`
  friend bool operator==(const Sides&, const Sides&) = default;
};

/// Makes facets of triangles that share edges and corners arbitrarily. Triangles with equal corners are one
/// facet, whatever their orientation. A triangle without area joins the long edge of one neighbour to the
/// short ones of others: it is left out, and that neighbour is cut at the point in between. So are triangles
/// no higher than the least height. Facets are in the order of their first triangles. Cost: sorting.
/// \pre corners are indices of points; used points are pairwise different
Facets make_facets(std::span<const Point> points, const FacetList& triangles, double least_height = 0);

}  // namespace multimesh::tetgen
