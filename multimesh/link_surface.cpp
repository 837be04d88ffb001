// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/link_surface.hpp"

#include <algorithm>
#include <set>

#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

constexpr std::size_t next(std::size_t i) {
  return i == 2 ? 0 : i + 1;
}

/// An edge of the link, as seen from a triangle: the one opposite its vertex i.
struct LinkEdge {
  std::size_t triangle, i;
  Index from, to;
};

/// Paths across a link, from one rim to another.
class CrossPaths {
 public:
  explicit CrossPaths(const std::vector<LinkTriangle>& link) : rims_(0) {
    for (const LinkTriangle& t : link) names_.insert(names_.end(), t.vertices.begin(), t.vertices.end());
    std::sort(names_.begin(), names_.end());
    names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
    rims_ = UnionFind(names_.size());
    on_rim_.assign(names_.size(), false);
    edges_.resize(names_.size());
    for (std::size_t t = 0; t < link.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const Index v = number(link[t].vertices[next(i)]), w = number(link[t].vertices[next(next(i))]);
        if (link[t].across[i] == no_index) {
          on_rim_[v] = on_rim_[w] = true;
          rims_.join(v, w);
        } else {
          edges_[v].push_back({t, i, v, w});
          edges_[w].push_back({t, i, w, v});
        }
      }
  }

  /// Two paths between the same two rims that have no common vertex, so that they part the link; empty if
  /// there are none.
  std::vector<LinkEdge> two_paths() {
    std::set<Index> rims;
    for (Index v = 0; v < names_.size(); ++v)
      if (on_rim_[v]) rims.insert(rims_.find(v));
    std::vector<LinkEdge> first;
    for (const Index rim : rims) {
      const std::vector<LinkEdge> path = shortest_path(rim, no_index, {});
      if (!path.empty() && (first.empty() || path.size() < first.size())) first = path;
    }
    if (first.empty()) return {};
    std::set<Index> blocked{first.front().from};
    for (const LinkEdge& e : first) blocked.insert(e.to);
    const std::vector<LinkEdge> second =
        shortest_path(rims_.find(first.front().from), rims_.find(first.back().to), blocked);
    if (second.empty()) return {};
    first.insert(first.end(), second.begin(), second.end());
    return first;
  }

 private:
  Index number(Index name) const {
    return static_cast<Index>(std::lower_bound(names_.begin(), names_.end(), name) - names_.begin());
  }

  // From one rim to another, or to a given one, through vertices that are on no rim and not blocked.
  std::vector<LinkEdge> shortest_path(Index rim, Index to_rim, const std::set<Index>& blocked) {
    std::vector<Index> queue;
    std::vector<LinkEdge> came_by(names_.size(), {0, 0, no_index, no_index});
    std::vector<bool> seen(names_.size(), false);
    for (const Index v : blocked) seen[v] = true;
    for (Index v = 0; v < names_.size(); ++v) {
      if (!on_rim_[v] || rims_.find(v) != rim || seen[v]) continue;
      seen[v] = true;
      queue.push_back(v);
    }
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (const LinkEdge& e : edges_[queue[q]]) {
        if (seen[e.to]) continue;
        came_by[e.to] = e;
        if (!on_rim_[e.to]) {
          seen[e.to] = true;
          queue.push_back(e.to);
        } else if (to_rim == no_index || rims_.find(e.to) == to_rim) {
          return walk_back(came_by, e.to);
        }
      }
    return {};
  }

  static std::vector<LinkEdge> walk_back(const std::vector<LinkEdge>& came_by, Index v) {
    std::vector<LinkEdge> path;
    for (; came_by[v].from != no_index; v = came_by[v].from) path.push_back(came_by[v]);
    std::reverse(path.begin(), path.end());
    return path;
  }

  std::vector<Index> names_;  // of vertices, ascending
  UnionFind rims_;
  std::vector<bool> on_rim_;
  std::vector<std::vector<LinkEdge>> edges_;  // inside the link, by vertex
};

/// The edge of a disk that is grown as far as possible. The rest may need another round.
std::vector<Index> edge_of_a_disk(const std::vector<LinkTriangle>& link) {
  std::vector<bool> in_disk(link.size(), false);
  std::set<Index> vertices;
  const auto add = [&](std::size_t t) {
    in_disk[t] = true;
    vertices.insert(link[t].vertices.begin(), link[t].vertices.end());
  };
  // A triangle may be added if it meets the disk in one edge and no other vertex, or in two edges.
  const auto may_join = [&](const LinkTriangle& t) {
    const auto beyond = [&](Index n) { return n != no_index && in_disk[n]; };
    const auto sides = std::count_if(t.across.begin(), t.across.end(), beyond);
    const auto common =
        std::count_if(t.vertices.begin(), t.vertices.end(), [&](Index v) { return vertices.contains(v); });
    return (sides == 1 && common == 2) || sides == 2;
  };
  add(0);
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t t = 0; t < link.size(); ++t)
      if (!in_disk[t] && may_join(link[t])) add(t), grown = true;
  }
  std::vector<Index> sides;
  for (std::size_t t = 0; t < link.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (in_disk[t] && link[t].across[i] != no_index && !in_disk[link[t].across[i]])
        sides.push_back(link[t].sides[i]);
  return sides;
}

}  // namespace

std::vector<Index> sides_to_part(const std::vector<LinkTriangle>& link) {
  std::vector<Index> sides;
  for (const LinkEdge& e : CrossPaths(link).two_paths()) sides.push_back(link[e.triangle].sides[e.i]);
  return sides.empty() ? edge_of_a_disk(link) : sides;
}

}  // namespace multimesh
