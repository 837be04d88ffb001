// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/tile_links.hpp"

#include <algorithm>
#include <tuple>

#include "multimesh/domains/periodic_domain/quotient_edges.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

/// The link of a vertex: triangles that must make one disk or sphere.
class LinkCheck {
 public:
  void clear() { corners_.clear(); }
  void add(Index vertex) { corners_.push_back(vertex); }

  bool is_disk_or_sphere() {
    const auto n = static_cast<Index>(corners_.size());
    read_edges();
    UnionFind triangles(n / 3), corners(n);  // joined across edges
    Index parts = n / 3, vertices = n, edges = 0, rim = 0;
    const auto join = [](UnionFind& sets, Index a, Index b, Index& count) {
      count -= sets.find(a) != sets.find(b);
      sets.join(a, b);
    };
    for (std::size_t i = 0, end = 0; i < edges_.size(); i = end) {
      while (end < edges_.size() && edges_[end].low == edges_[i].low && edges_[end].high == edges_[i].high)
        ++end;
      if (end - i > 2) return false;
      ++edges, rim += end - i == 1;
      if (end - i == 1) continue;
      const Edge &e = edges_[i], &f = edges_[i + 1];
      join(triangles, e.at_low / 3, f.at_low / 3, parts);
      join(corners, e.at_low, f.at_low, vertices);
      join(corners, e.at_high, f.at_high, vertices);
    }
    return parts == 1 && !is_pinched(vertices) && vertices + n / 3 == edges + (rim > 0 ? 1 : 2);
  }

 private:
  struct Edge {
    Index low, high;        // vertices
    Index at_low, at_high;  // corners
  };

  void read_edges() {
    edges_.clear();
    for (Index c = 0; c < corners_.size(); ++c) {
      const Index d = c % 3 == 2 ? c - 2 : c + 1;
      edges_.push_back(corners_[c] < corners_[d] ? Edge{corners_[c], corners_[d], c, d}
                                                 : Edge{corners_[d], corners_[c], d, c});
    }
    std::ranges::sort(edges_, {}, [](const Edge& e) { return std::tie(e.low, e.high); });
  }

  /// Whether a vertex has more than one fan of triangles.
  bool is_pinched(Index fans) {
    std::ranges::sort(corners_);
    return static_cast<Index>(std::unique(corners_.begin(), corners_.end()) - corners_.begin()) != fans;
  }

  std::vector<Index> corners_;  // vertices of triangles, three each
  std::vector<Edge> edges_;
};

/// Whether two copies of a vertex have the same place.
bool has_double_vertices(const LabelledTile& tile, const std::vector<Index>& copies) {
  std::vector<std::pair<Index, LatticeVector>> places;
  for (const Index v : copies) places.emplace_back(tile.vertex_class[v], tile.offset[v]);
  std::ranges::sort(places);
  return std::ranges::adjacent_find(places) != places.end();
}

}  // namespace

bool is_manifold_tile(const LabelledTile& tile) {
  const std::vector<bool> has_copies = with_copies(tile);
  std::vector<std::array<Index, 2>> around;  // a vertex and a facet of it
  std::vector<Index> copies;
  for (Index v = 0; v < has_copies.size(); ++v)
    if (has_copies[v]) copies.push_back(v);
  if (has_double_vertices(tile, copies)) return false;
  for (Index f = 0; f < tile.facets.size(); ++f)
    for (const Index v : tile.facets.facet(f))
      if (has_copies[v]) around.push_back({v, f});
  std::ranges::sort(around);
  LinkCheck link;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto [v, f] = around[i];
    for (const Index w : tile.facets.facet(f))
      if (w != v) link.add(w);
    if (i + 1 < around.size() && around[i + 1][0] == v) continue;
    if (!link.is_disk_or_sphere()) return false;
    link.clear();
  }
  return true;
}

}  // namespace multimesh
