// SPDX-License-Identifier: BSD-3-Clause
// Of edges with the same ends all but the shortest are too many, and so are loops. They are split in rounds,
// no two of one facet in the same round. A split may make new edges that are too many; that this ends is
// certain only if edges are split that are the longest of all facets around them, as in bisection of the
// longest edge (Rivara 1984): then new edges are shorter than the split one by a factor of sqrt(3)/2 or less,
// and edges shorter than half of every lattice vector are not too many. Splitting them directly adds fewer
// facets, and is tried first.
#include "multimesh/domains/periodic_domain/refine_tile.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "multimesh/domains/periodic_domain/quotient_edges.hpp"

namespace multimesh {

namespace {

class Refiner {
 public:
  Refiner(LabelledTile& tile, int direct_rounds) : tile_(tile), direct_rounds_(direct_rounds) {}

  std::size_t run() {
    std::size_t splits = 0;
    for (int round = 0;; ++round) {
      const QuotientEdges edges(tile_);
      rank_by_length(edges);
      find_too_many(edges);
      if (std::none_of(wanted_.begin(), wanted_.end(), [](bool w) { return w; })) return splits;
      if (round >= direct_rounds_) want_longest(edges);
      choose(edges, round >= direct_rounds_);
      split_chosen(edges);
      splits += static_cast<std::size_t>(std::count(chosen_.begin(), chosen_.end(), true));
    }
  }

 private:
  // A total order of the edges, the longest last.
  void rank_by_length(const QuotientEdges& edges) {
    std::vector<double> length(edges.size());
    for (Index e = 0; e < edges.size(); ++e) {
      const auto [v, w] = edges.tile_edge(e);
      length[e] = (tile_.point[v] - tile_.point[w]).norm();
    }
    by_rank_.resize(edges.size());
    std::iota(by_rank_.begin(), by_rank_.end(), Index{0});
    std::stable_sort(by_rank_.begin(), by_rank_.end(),
                     [&](Index e, Index f) { return length[e] < length[f]; });
    rank_.resize(edges.size());
    for (Index r = 0; r < by_rank_.size(); ++r) rank_[by_rank_[r]] = r;
  }

  void find_too_many(const QuotientEdges& edges) {
    wanted_.assign(edges.size(), false);
    for (Index e = 0; e < edges.size();) {
      const Index end = edges.parallel(e)[1];
      const bool loops = edges[e].is_loop();
      const auto shortest =
          static_cast<Index>(std::min_element(rank_.begin() + e, rank_.begin() + end) - rank_.begin());
      for (; e < end; ++e) wanted_[e] = loops || e != shortest;
    }
  }

  Index longest_of(const QuotientEdges& edges, std::size_t f) const {
    const auto list = edges.of_facet(f);
    return *std::max_element(list.begin(), list.end(), [&](Index a, Index b) { return rank_[a] < rank_[b]; });
  }

  // With an edge, also the longest one of each facet around it.
  void want_longest(const QuotientEdges& edges) {
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t f = 0; f < tile_.facets.size(); ++f) {
        const auto list = edges.of_facet(f);
        const Index longest = longest_of(edges, f);
        if (wanted_[longest] || std::none_of(list.begin(), list.end(), [&](Index e) { return wanted_[e]; }))
          continue;
        wanted_[longest] = changed = true;
      }
    }
  }

  // No two edges of one facet: the longest first.
  void choose(const QuotientEdges& edges, bool longest_only) {
    std::vector<std::vector<Index>> around(edges.size());
    for (Index f = 0; f < tile_.facets.size(); ++f)
      for (const Index e : edges.of_facet(f))
        if (wanted_[e]) around[e].push_back(f);
    chosen_.assign(edges.size(), false);
    std::vector<bool> taken(tile_.facets.size(), false);
    for (auto e = by_rank_.rbegin(); e != by_rank_.rend(); ++e) {
      if (!wanted_[*e]) continue;
      const bool possible = std::none_of(around[*e].begin(), around[*e].end(), [&](Index f) {
        return taken[f] || (longest_only && longest_of(edges, f) != *e);
      });
      if (!possible) continue;
      chosen_[*e] = true;
      for (const Index f : around[*e]) taken[f] = true;
    }
  }

  void split_chosen(const QuotientEdges& edges) {
    std::vector<Index> class_of(edges.size(), no_index);
    std::map<std::array<Index, 2>, Index> middle_of;
    const std::size_t n = tile_.facets.corners_per_facet(), facets = tile_.facets.size();
    for (std::size_t f = 0; f < facets; ++f) {
      std::size_t slot = 0, p = 0, q = 0;
      Index e = no_index;
      for (std::size_t j = 1; j < n; ++j)
        for (std::size_t i = 0; i < j; ++i, ++slot)
          if (chosen_[edges.of_facet(f)[slot]]) e = edges.of_facet(f)[slot], p = i, q = j;
      if (e == no_index) continue;
      Index v = tile_.facets.corners[f * n + p], w = tile_.facets.corners[f * n + q];
      quotient_edge(tile_, v, w);
      const auto [entry, is_new] = middle_of.try_emplace({v, w}, static_cast<Index>(tile_.point.size()));
      if (is_new) add_middle(v, w, class_of[e]);
      const std::vector<Index> old(tile_.facets.facet(f).begin(), tile_.facets.facet(f).end());
      tile_.facets.corners.insert(tile_.facets.corners.end(), old.begin(), old.end());
      tile_.facets.corners[f * n + p] = entry->second;
      tile_.facets.corners[(tile_.facets.size() - 1) * n + q] = entry->second;
      tile_.input_facet.push_back(tile_.input_facet[f]);
    }
    tile_.facets.vertices = static_cast<Index>(tile_.point.size());
  }

  // Copies of an edge run the same way, so that their middles lie from each other as their first ends do.
  void add_middle(Index v, Index w, Index& of_edge) {
    if (of_edge == no_index) of_edge = tile_.classes++;
    const Vec3 middle = 0.5 * (tile_.point[v] + tile_.point[w]);
    tile_.point.push_back(middle);
    tile_.offset.push_back(LatticeVector(tile_.offset[v]));
    tile_.vertex_class.push_back(of_edge);
  }

  LabelledTile& tile_;
  int direct_rounds_;
  std::vector<Index> rank_, by_rank_;
  std::vector<bool> wanted_, chosen_;
};

}  // namespace

std::size_t refine_tile(LabelledTile& tile, int direct_rounds) {
  return Refiner(tile, direct_rounds).run();
}

}  // namespace multimesh
