// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/quotient_edges.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "multimesh/pair_numbers.hpp"

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

std::vector<bool> with_copies(const LabelledTile& tile) {
  std::vector<std::uint8_t> copies(tile.classes, 0);
  for (const Index c : tile.vertex_class)
    if (c != no_index && copies[c] < 2) ++copies[c];
  std::vector<bool> found;
  for (const Index c : tile.vertex_class) found.push_back(c != no_index && copies[c] > 1);
  return found;
}

namespace {

/// Whether an edge is a loop, or leads from one end to the other another way than another one. Only where an
/// end has several copies can that be, if the tile itself is a simplicial complex.
bool has_short_cycle(const LabelledTile& tile) {
  const std::vector<bool> has_copies = with_copies(tile);
  PairNumbers pairs(tile.classes);
  for (const Index v : tile.facets.corners) pairs.expect(tile.vertex_class[v]);
  std::vector<LatticeVector> shifts;
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    const auto corners = tile.facets.facet(f);
    for (std::size_t j = 1; j < corners.size(); ++j)
      for (std::size_t i = 0; i < j; ++i) {
        Index v = corners[i], w = corners[j];
        if (!has_copies[v] && !has_copies[w]) continue;
        const QuotientEdge edge = quotient_edge(tile, v, w);
        const Index pair = pairs(edge.low, edge.high);
        if (pair == shifts.size()) shifts.push_back(edge.shift);
        if (edge.is_loop() || shifts[pair] != edge.shift) return true;
      }
  }
  return false;
}

int axes_of(const LatticeVector& v) {
  return static_cast<int>(std::count_if(v.begin(), v.end(), [](int x) { return x != 0; }));
}

LatticeVector positive(const LatticeVector& v) {
  return v < LatticeVector{} ? LatticeVector{} - v : v;
}

}  // namespace

std::optional<std::string> too_short(const LabelledTile& tile) {
  if (!has_short_cycle(tile)) return std::nullopt;
  const QuotientEdges edges(tile);
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
  std::vector<Index> count(tile.classes, 0);
  for (const Index v : tile.facets.corners) ++count[tile.vertex_class[v]];
  // With the same vertex of those with the fewest facets.
  std::vector<Index> last(tile.classes, no_index), previous(facets);
  for (Index f = 0; f < facets; ++f) {
    const std::span corners = std::span(vertices[f]).first(tile.facets.corners_per_facet());
    Index& of_vertex = last[*std::ranges::min_element(corners, {}, [&](Index v) { return count[v]; })];
    for (Index g = of_vertex; g != no_index; g = previous[g])
      if (vertices[g] == vertices[f]) return std::array{tile.input_facet[g], tile.input_facet[f]};
    previous[f] = std::exchange(of_vertex, f);
  }
  return std::nullopt;
}

}  // namespace multimesh
