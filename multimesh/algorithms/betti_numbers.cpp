// SPDX-License-Identifier: BSD-3-Clause
// Cohomology modulo 2, one vertex at a time. A cocycle assigns a number to each edge so that the three
// numbers of every triangle sum up to 0; edges of a spanning tree may be assigned 0. When a vertex is added,
// the triangles added with it tie together its edges to earlier vertices: within a connected part of the
// earlier vertices around it, one edge determines the others. The first part is tied to the tree; each
// further part adds an unknown. Triangles that close a loop among them are equations, and each independent
// one removes an unknown. The remaining unknowns are the loops.
#include "multimesh/algorithms/betti_numbers.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace multimesh {

namespace {

/// A sum of unknowns modulo 2, ascending.
using Sum = std::vector<Index>;

Sum operator+(const Sum& a, const Sum& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  Sum sum;
  std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(sum));
  return sum;
}

class Unknowns {
 public:
  Sum add() {
    equals_.emplace_back();
    is_known_.push_back(false);
    return {static_cast<Index>(equals_.size() - 1)};
  }
  /// Replaces known unknowns by their values, which consist of earlier ones.
  void reduce(Sum& s) const {
    while (true) {
      const auto known = std::find_if(s.rbegin(), s.rend(), [&](Index u) { return is_known_[u]; });
      if (known == s.rend()) return;
      const Index u = *known;
      s = s + Sum{u};
      s = s + equals_[u];
    }
  }
  void require_zero(Sum s) {
    reduce(s);
    if (s.empty()) return;
    const Index u = s.back();
    s.pop_back();
    equals_[u] = std::move(s);
    is_known_[u] = true;
  }
  std::size_t left() const {
    return static_cast<std::size_t>(std::count(is_known_.begin(), is_known_.end(), false));
  }

 private:
  std::vector<Sum> equals_;
  std::vector<bool> is_known_;
};

class LoopCounter {
 public:
  explicit LoopCounter(const FacetList& facets)
      : facets_(facets), values_(facets.vertices), local_(facets.vertices, no_index) {
    first_.assign(std::size_t{facets.vertices} + 1, 0);
    for (const Index v : facets.corners) ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    around_.resize(facets.corners.size());
    std::vector<Index> end(first_.begin(), first_.end() - 1);
    for (Index c = 0; c < facets.corners.size(); ++c)
      around_[end[facets.corners[c]]++] = c / static_cast<Index>(facets.corners_per_facet());
  }

  BettiNumbers run() {
    order_by_breadth();
    for (const Index v : order_) add_vertex(v);
    result_.handles = unknowns_.left();
    return result_;
  }

 private:
  bool is_used(Index v) const { return first_[v] < first_[v + 1]; }

  void order_by_breadth() {
    rank_.assign(facets_.vertices, no_index);
    const auto reach = [&](Index v) {
      if (rank_[v] != no_index) return false;
      rank_[v] = static_cast<Index>(order_.size());
      order_.push_back(v);
      return true;
    };
    std::size_t next = 0;
    for (Index start = 0; start < facets_.vertices; ++start) {
      if (!is_used(start) || !reach(start)) continue;
      ++result_.components;
      for (; next < order_.size(); ++next) {
        const Index v = order_[next];
        for (Index i = first_[v]; i < first_[v + 1]; ++i)
          for (const Index w : facets_.facet(around_[i])) reach(w);
      }
    }
  }

  // The earlier vertices around v, numbered, and the pairs of them that make a triangle with it.
  void read_lower_link(Index v) {
    lower_.clear();
    pairs_.clear();
    for (Index i = first_[v]; i < first_[v + 1]; ++i) {
      const auto corners = facets_.facet(around_[i]);
      for (const Index w : corners) {
        if (w == v || rank_[w] > rank_[v]) continue;
        if (local_[w] == no_index) local_[w] = static_cast<Index>(lower_.size()), lower_.push_back(w);
      }
      for (const Index w : corners)
        for (const Index x : corners)
          if (x != w && local_[w] != no_index && local_[x] != no_index)
            pairs_.push_back({local_[w], local_[x]});
    }
    std::sort(pairs_.begin(), pairs_.end());
    pairs_.erase(std::unique(pairs_.begin(), pairs_.end()), pairs_.end());
    for (const Index w : lower_) local_[w] = no_index;
  }

  /// Of an edge between two earlier vertices.
  const Sum& value(Index v, Index w) const {
    static const Sum zero;
    if (rank_[v] < rank_[w]) std::swap(v, w);
    for (const auto& [other, sum] : values_[v])
      if (other == w) return sum;
    return zero;
  }

  void add_vertex(Index v) {
    read_lower_link(v);
    reached_.assign(lower_.size(), false);
    here_.assign(lower_.size(), {});
    for (Index part = 0; part < lower_.size(); ++part) {
      if (reached_[part]) continue;
      if (part != 0) here_[part] = unknowns_.add();
      reached_[part] = true;
      queue_.assign(1, part);
      for (std::size_t q = 0; q < queue_.size(); ++q) spread(queue_[q]);
    }
    for (std::size_t i = 0; i < lower_.size(); ++i)
      if (!here_[i].empty()) values_[v].emplace_back(lower_[i], std::move(here_[i]));
  }

  void spread(Index from) {
    for (auto p = std::lower_bound(pairs_.begin(), pairs_.end(), std::array<Index, 2>{from, 0});
         p != pairs_.end() && (*p)[0] == from; ++p) {
      const Index to = (*p)[1];
      Sum sum = here_[from] + value(lower_[from], lower_[to]);
      if (reached_[to]) {
        if (from < to) unknowns_.require_zero(sum + here_[to]);
        continue;
      }
      unknowns_.reduce(sum);
      here_[to] = std::move(sum);
      reached_[to] = true;
      queue_.push_back(to);
    }
  }

  const FacetList& facets_;
  std::vector<Index> first_,
      around_;  // facets around a vertex v: around_[first_[v]] .. around_[first_[v + 1]]
  std::vector<Index> rank_, order_;
  std::vector<std::vector<std::pair<Index, Sum>>> values_;  // of edges to earlier vertices, but for zeros
  std::vector<Sum> here_;                                   // of those from the vertex being added
  Unknowns unknowns_;
  std::vector<Index> local_, lower_, queue_;
  std::vector<std::array<Index, 2>> pairs_;
  std::vector<bool> reached_;
  BettiNumbers result_;
};

}  // namespace

BettiNumbers betti_numbers(const FacetList& facets) {
  return LoopCounter(facets).run();
}

}  // namespace multimesh
