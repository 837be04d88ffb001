// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/tetgen/facets.hpp"

#include <algorithm>
#include <numeric>

#include "adapters/tetgen/flat_triangles.hpp"
#include "adapters/tetgen/surface_measure.hpp"

namespace multimesh::tetgen {

namespace {

using Corners = std::array<Index, 3>;

/// A piece of a triangle of the input; usually all of it.
struct Piece {
  Corners corners{}, key{};
  Index triangle = 0;
  bool even = false;  ///< the key has the orientation of the corners
};

Piece make_piece(const Corners& corners, Index triangle) {
  Piece piece{corners, corners, triangle, false};
  piece.even = sort_corners(piece.key);
  return piece;
}

/// Cuts a triangle at the points that lie on its edges. The order of cuts depends only on the numbers of
/// points: two triangles with the same corners get the same pieces.
void cut(const FlatTriangles& flat, const Corners& c, std::vector<Corners>& out, std::size_t depth = 0) {
  std::size_t best = 3;
  Corners least{no_index, no_index, no_index};  // the edge, by ascending corners, and the first point on it
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [low, high] = std::minmax({c[k], c[(k + 1) % 3]});
    const std::vector<Index> between = flat.points_on(low, high, c[(k + 2) % 3]);
    if (between.empty()) continue;
    if (const Corners found{low, high, between.front()}; found < least) least = found, best = k;
  }
  constexpr std::size_t most = 10'000;  // only intersecting triangles get this far
  if (best == 3 || out.size() + depth > most) return out.push_back(c);
  const Index a = c[best], b = c[(best + 1) % 3], apex = c[(best + 2) % 3], x = least[2];
  cut(flat, {a, x, apex}, out, depth + 1);
  cut(flat, {x, b, apex}, out, depth + 1);
}

std::vector<Piece> make_pieces(std::span<const Point> points, const FacetList& triangles, double least_height,
                               Facets& counts) {
  std::vector<Piece> pieces;
  std::vector<Corners> without_area;
  for (Index t = 0; t < triangles.size(); ++t) {
    const auto facet = triangles.facet(t);
    const Corners c{facet[0], facet[1], facet[2]};
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[0])
      ++counts.collapsed;
    else if (!has_area(points, c, least_height))
      without_area.push_back(c);
    else
      pieces.push_back(make_piece(c, t));
  }
  counts.flat = without_area.size();
  if (without_area.empty()) return pieces;

  std::vector<bool> used(points.size(), false);
  for (const Piece& p : pieces)
    for (const Index v : p.corners) used[v] = true;
  const FlatTriangles flat(points, without_area, used, least_height);
  std::vector<Piece> all;
  for (const Piece& p : pieces) {
    std::vector<Corners> parts;
    cut(flat, p.corners, parts);
    counts.split += parts.size() > 1;
    for (const Corners& part : parts) all.push_back(make_piece(part, p.triangle));
  }
  return all;
}

}  // namespace

bool sort_corners(std::array<Index, 3>& c) {
  bool even = true;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (c[i] > c[j]) std::swap(c[i], c[j]), even = !even;
  };
  order(0, 1), order(1, 2), order(0, 1);
  return even;
}

Facets make_facets(std::span<const Point> points, const FacetList& triangles, double least_height) {
  Facets facets;
  facets.least_height = least_height;
  const std::vector<Piece> pieces = make_pieces(points, triangles, least_height, facets);
  // Pieces are in the order of their triangles; `first` has those with equal corners contiguous.
  std::vector<Index> by_key(pieces.size());
  std::iota(by_key.begin(), by_key.end(), Index{0});
  std::sort(by_key.begin(), by_key.end(), [&](Index a, Index b) {
    return pieces[a].key != pieces[b].key ? pieces[a].key < pieces[b].key : a < b;
  });
  std::vector<std::span<const Index>> groups;
  for (auto i = by_key.begin(); i != by_key.end();) {
    const auto end = std::find_if(i, by_key.end(), [&](Index p) { return pieces[p].key != pieces[*i].key; });
    groups.emplace_back(i, end);
    i = end;
  }
  std::sort(groups.begin(), groups.end(), [](const auto& a, const auto& b) { return a[0] < b[0]; });
  for (const auto& group : groups) {
    const Piece& first = pieces[group[0]];
    facets.corners.insert(facets.corners.end(), first.corners.begin(), first.corners.end());
    for (const Index p : group) facets.sources.push_back({pieces[p].triangle, pieces[p].even != first.even});
    facets.begin.push_back(static_cast<Index>(facets.sources.size()));
  }
  return facets;
}

}  // namespace multimesh::tetgen
