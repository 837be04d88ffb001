// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/quotient_edges.hpp"

#include <algorithm>
#include <numeric>

namespace multimesh {

QuotientEdges::QuotientEdges(const LabelledTile& tile)
    : n_(tile.facets.dimension == 3 ? 6 : 3), of_facet_(n_ * tile.facets.size()) {
  struct Use {
    QuotientEdge edge;
    Index v, w;
    std::size_t slot;
  };
  std::vector<Use> uses;
  uses.reserve(of_facet_.size());
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    const auto corners = tile.facets.facet(f);
    for (std::size_t j = 1; j < corners.size(); ++j)
      for (std::size_t i = 0; i < j; ++i) {
        Index v = corners[i], w = corners[j];
        const QuotientEdge edge = quotient_edge(tile, v, w);
        uses.push_back({edge, v, w, uses.size()});
      }
  }
  std::sort(uses.begin(), uses.end(),
            [](const Use& a, const Use& b) { return a.edge != b.edge ? a.edge < b.edge : a.slot < b.slot; });
  for (const Use& use : uses) {
    if (edges_.empty() || edges_.back() != use.edge) {
      edges_.push_back(use.edge);
      tile_edge_.push_back({use.v, use.w});
    }
    of_facet_[use.slot] = size() - 1;
  }
}

std::array<Index, 2> QuotientEdges::parallel(Index e) const {
  const auto same = [&](Index f) {
    return edges_[f].low == edges_[e].low && edges_[f].high == edges_[e].high;
  };
  Index begin = e, end = e + 1;
  while (begin > 0 && same(begin - 1)) --begin;
  while (end < size() && same(end)) ++end;
  return {begin, end};
}

LabelledTile at_copies(const LabelledTile& tile) {
  std::vector<std::uint8_t> copies(tile.classes, 0);
  for (const Index c : tile.vertex_class)
    if (c != no_index && copies[c] < 2) ++copies[c];
  LabelledTile part{{tile.facets.dimension, tile.facets.vertices, {}},
                    {},
                    tile.point,
                    tile.vertex_class,
                    tile.offset,
                    tile.classes};
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    const auto corners = tile.facets.facet(f);
    if (std::ranges::none_of(corners, [&](Index v) { return copies[tile.vertex_class[v]] > 1; })) continue;
    part.facets.corners.insert(part.facets.corners.end(), corners.begin(), corners.end());
    part.input_facet.push_back(tile.input_facet[f]);
  }
  return part;
}

namespace {

int axes_of(const LatticeVector& v) {
  return static_cast<int>(std::count_if(v.begin(), v.end(), [](int x) { return x != 0; }));
}

LatticeVector positive(const LatticeVector& v) {
  return v < LatticeVector{} ? LatticeVector{} - v : v;
}

}  // namespace

std::optional<std::string> too_short(const QuotientEdges& edges) {
  // The shortest cycle for each combination of periods; those along a single axis first, x before y.
  struct Cycle {
    int axes, length;
    LatticeVector around;
    Index first, second;
    auto operator<=>(const Cycle&) const = default;
  };
  std::vector<Cycle> cycles;
  for (Index e = 0; e < edges.size(); ++e) {
    const QuotientEdge& edge = edges[e];
    if (edge.is_loop()) cycles.push_back({axes_of(edge.shift), 1, positive(edge.shift), e, e});
    if (e + 1 < edges.size() && edges[e + 1].low == edge.low && edges[e + 1].high == edge.high) {
      const LatticeVector around = edges[e + 1].shift - edge.shift;
      cycles.push_back({axes_of(around), 2, positive(around), e, e + 1});
    }
  }
  if (cycles.empty()) return std::nullopt;
  std::sort(cycles.begin(), cycles.end(), [](const Cycle& a, const Cycle& b) {
    return std::tie(a.axes, b.around, a.length, a.first) < std::tie(b.axes, a.around, b.length, b.first);
  });
  std::string message;
  const auto name = [&](Index e) {
    const auto [v, w] = edges.tile_edge(e);
    return std::to_string(v) + "-" + std::to_string(w);
  };
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    const Cycle& c = cycles[i];
    if (i > 0 && (c.around == cycles[i - 1].around || c.axes > cycles[0].axes)) continue;
    if (!message.empty()) message += "; ";
    message += "the tile has only " + std::to_string(c.length) + (c.length == 1 ? " edge (" : " edges (") +
               name(c.first) + (c.length == 2 ? ", " + name(c.second) : "") + ") along " + name_of(c.around) +
               "; at least 3 are needed";
  }
  return message;
}

std::optional<std::array<Index, 2>> double_facet(const LabelledTile& tile) {
  const auto facets = static_cast<Index>(tile.facets.size());
  std::vector<std::array<Index, 4>> vertices(facets, {no_index, no_index, no_index, no_index});
  for (Index f = 0; f < facets; ++f) {
    const auto corners = tile.facets.facet(f);
    for (std::size_t i = 0; i < corners.size(); ++i) vertices[f][i] = tile.vertex_class[corners[i]];
    std::sort(vertices[f].begin(), vertices[f].end());
  }
  std::vector<Index> order(facets);
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(),
            [&](Index f, Index g) { return vertices[f] != vertices[g] ? vertices[f] < vertices[g] : f < g; });
  for (Index i = 1; i < facets; ++i)
    if (vertices[order[i - 1]] == vertices[order[i]])
      return std::array{tile.input_facet[order[i - 1]], tile.input_facet[order[i]]};
  return std::nullopt;
}

}  // namespace multimesh
