// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// Facets by their vertices, dimension + 1 each, side by side: \#F x (dimension + 1).
struct FacetList {
  int dimension = 2;
  Index vertices = 0;  ///< indices are below this
  std::vector<Index> corners;

  std::size_t size() const noexcept { return corners.size() / corners_per_facet(); }
  std::size_t corners_per_facet() const noexcept { return static_cast<std::size_t>(dimension) + 1; }
  std::span<const Index> facet(std::size_t f) const {
    return {corners.data() + f * corners_per_facet(), corners_per_facet()};
  }
};

/// \throw InputError for a facet with an index out of range or a repeated vertex; `name(f)` is how it is
/// called
void require_corners(const FacetList& facets, const std::function<std::string(std::size_t facet)>& name);

/// Facets made manifold: the same ones in the same order, with vertices split where it was necessary.
struct Cut {
  FacetList facets;
  std::vector<Index> source;  ///< per new vertex: the one that it is a copy of
  std::vector<bool>
      reversed;  ///< per facet: whether its first two corners were exchanged; the fewer ones of a component
};

struct CutOptions {
  /// Vertices at which all curves end, whatever their degree (dimension 1): where a type changes.
  std::function<bool(Index vertex)> ends_at;
};

/// Cuts points, edges, triangles or tetrahedra into a manifold mesh that is a proper simplicial complex. Each
/// point becomes a vertex of its own. Triangles
/// stay joined across edges with just two of them and are re-oriented to agree; edges with three or more,
/// pinched vertices and places where no orientation agrees come apart. Edges stay joined at vertices with
/// just two of them. Tetrahedra stay joined across faces with just two of them and are re-oriented to agree;
/// vertices and edges come apart where the tetrahedra around them do not hang together by faces, and vertices
/// whose link is neither a sphere nor a disk are parted into several. Facets with the same vertices come
/// apart. Where no renumbering of vertices can separate two simplices with the same vertices, facets around
/// one of them are taken out of their neighbourhood. Cost: sorting. \throw InputError for a facet that
/// repeats a vertex, naming it
Cut cut(const FacetList& facets, const CutOptions& options = {});

}  // namespace multimesh
