// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "multimesh/dart.hpp"

namespace multimesh {

/// Facets by their vertices, dimension + 1 each, contiguous: \#F x (dimension + 1).
struct FacetList {
  int dimension = 2;
  Index vertices = 0;  ///< all indices are below this
  std::vector<Index> corners;

  std::size_t size() const noexcept { return corners.size() / corners_per_facet(); }
  std::size_t corners_per_facet() const noexcept { return static_cast<std::size_t>(dimension) + 1; }
  std::span<const Index> facet(std::size_t f) const {
    return {corners.data() + f * corners_per_facet(), corners_per_facet()};
  }
};

/// \throw InputError for a facet with an index out of range or a repeated vertex; `name(f)` names the facet
/// in the message
void require_corners(const FacetList& facets, const std::function<std::string(std::size_t facet)>& name);

/// A facet list made manifold: the same facets in the same order, with vertices split where necessary.
struct Cut {
  FacetList facets;
  std::vector<Index> source;  ///< per new vertex: the original of which it is a copy
  std::vector<bool>
      reversed;  ///< per facet: whether its first two corners were exchanged; the minority of a component
};

struct CutOptions {
  /// Vertices at which all curves end, whatever their degree (dimension 1): where a type changes.
  std::function<bool(Index vertex)> ends_at;
};

/// Cuts points, edges, triangles or tetrahedra into a manifold mesh that is a proper simplicial complex. Each
/// point becomes a vertex of its own. Triangles stay joined across edges with exactly two of them and are
/// re-oriented to agree; they are separated at edges with three or more, at pinched vertices, and where no
/// orientation agrees. Edges stay joined at vertices with exactly two of them. Tetrahedra stay joined across
/// faces with exactly two of them and are re-oriented to agree; vertices and edges are separated where the
/// tetrahedra around them are not connected through faces, and vertices whose link is neither a sphere nor a
/// disk are separated into several. Facets with the same vertices are separated. Where no renumbering of
/// vertices can separate two simplices with the same vertices, facets around one of them are disconnected
/// from their neighbours. Cost: sorting.
/// \throw InputError naming a facet that repeats a vertex
Cut cut(const FacetList& facets, const CutOptions& options = {});

}  // namespace multimesh
