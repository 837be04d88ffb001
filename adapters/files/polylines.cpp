// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/files/polylines.hpp"

#include <algorithm>

#include "multimesh/domains/make_mesh.hpp"

namespace multimesh::files {

namespace {

/// Edges from a vertex to itself are counted only.
FacetList edges_of(const io::PolygonSoup& soup, std::size_t& collapsed) {
  FacetList edges{1, static_cast<Index>(soup.positions.size()), {}};
  for (std::size_t l = 0; l < soup.line_count(); ++l)
    for (std::uint32_t i = soup.line_begin[l]; i + 1 < soup.line_begin[l + 1]; ++i) {
      const auto a = static_cast<Index>(soup.line_corners[i]),
                 b = static_cast<Index>(soup.line_corners[i + 1]);
      if (a == b)
        ++collapsed;
      else
        edges.corners.insert(edges.corners.end(), {a, b});
    }
  return edges;
}

}  // namespace

PolylineReport report_polylines(const io::PolygonSoup& soup) {
  PolylineReport r;
  const FacetList edges = edges_of(soup, r.collapsed);
  r.curves.edges = edges.size();
  std::vector<std::size_t> degree(soup.positions.size(), 0);
  for (const Index v : edges.corners) ++degree[v];
  r.vertices = static_cast<std::size_t>(std::ranges::count_if(degree, [](std::size_t d) { return d > 0; }));
  r.curves.ends = static_cast<std::size_t>(std::ranges::count(degree, 1U));
  r.curves.junctions =
      static_cast<std::size_t>(std::ranges::count_if(degree, [](std::size_t d) { return d > 2; }));
  // Cut at its junctions, the graph falls into its curves.
  r.curves.curves = report(*make_mesh(cut(edges).facets)).components;
  return r;
}

}  // namespace multimesh::files
