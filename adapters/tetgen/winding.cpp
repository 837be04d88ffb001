// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/winding.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "multimesh/union_find.hpp"

namespace multimesh::tetgen {

namespace {

/// By how much the winding number changes from the front of a facet to its back: 0 if it is listed with both
/// orientations.
int step_of(const Facets& facets, Index f) {
  const auto sources = facets.sources_of(f);
  const auto is_reversed = [](const FacetSource& s) { return s.reversed; };
  if (std::all_of(sources.begin(), sources.end(), is_reversed)) return -1;
  return std::none_of(sources.begin(), sources.end(), is_reversed) ? 1 : 0;
}

/// The facets of one shell between the same two regions, the first being the one with the lower node.
struct Border {
  std::array<Index, 2> nodes{};
  std::vector<Index> facets;
  std::vector<int> steps;  ///< from the first node to the second, per facet

  /// What most facets say; nothing if as many say something else.
  std::optional<int> step() const {
    for (const int s : {-1, 0, 1})
      if (2 * static_cast<std::size_t>(std::count(steps.begin(), steps.end(), s)) > steps.size()) return s;
    return {};
  }
};

using Shell = std::map<std::array<Index, 2>, Border>;

/// Nodes are regions; the last one is the outside.
class Walk {
 public:
  Walk(const Facets& facets, const std::vector<Sides>& sides, std::size_t regions)
      : outside_(static_cast<Index>(regions)), reached_(regions + 1, false), shells_at_(regions + 1) {
    result_.numbers.assign(regions + 1, 0);
    UnionFind joined(
        facets.corners.empty() ? 0 : *std::max_element(facets.corners.begin(), facets.corners.end()) + 1);
    for (Index f = 0; f < facets.size(); ++f)
      for (const Index v : facets.facet(f)) joined.join(v, facets.facet(f)[0]);
    for (Index f = 0; f < facets.size(); ++f) {
      if (sides[f].behind == sides[f].before) continue;
      const Index behind = std::min(sides[f].behind, outside_), before = std::min(sides[f].before, outside_);
      const std::array<Index, 2> nodes{std::min(behind, before), std::max(behind, before)};
      const Index shell = joined.find(facets.facet(f)[0]);
      Border& border = shells_[shell][nodes];
      border.nodes = nodes;
      border.facets.push_back(f);
      const int step = step_of(facets, f);
      border.steps.push_back(nodes[0] == before ? step : -step);
      for (const Index n : nodes) shells_at_[n].insert(shell);
    }
  }

  /// Without `by_orientation` all that is enclosed is taken as filled.
  Winding run(bool by_orientation) {
    by_orientation_ = by_orientation;
    std::vector<Index> queue{outside_};
    reached_[outside_] = true;
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (const Index s : shells_at_[queue[q]])
        if (const auto shell = shells_.find(s); shell != shells_.end()) {
          cross(shell->second, queue[q], queue);
          shells_.erase(shell);
        }
    result_.numbers.pop_back();
    std::sort(result_.turned.begin(), result_.turned.end());
    std::sort(result_.assumed.begin(), result_.assumed.end());
    return std::move(result_);
  }

  /// Whether the orientation of some shell of several regions tells nothing: that is how files list the
  /// interfaces between materials, each once and in any orientation.
  bool has_contradiction() const { return has_contradiction_; }

 private:
  /// Gives numbers to all that a shell separates from `from`. Shells and regions are a tree: all the others
  /// are new.
  void cross(const Shell& shell, Index from, std::vector<Index>& queue) {
    std::map<Index, int> numbers;
    if (by_orientation_) numbers = follow(shell, from);
    const bool is_known = !numbers.empty();
    has_contradiction_ |= !is_known && shell.size() > 1;
    for (const auto& [nodes, border] : shell)
      for (const Index n : nodes) {
        if (reached_[n]) continue;
        reached_[n] = true;
        queue.push_back(n);
        result_.numbers[n] = is_known ? numbers.at(n) : result_.numbers[from] + 1;
        if (!is_known) result_.assumed.push_back(n);
      }
  }

  /// The numbers by the steps; none if they tell nothing.
  std::map<Index, int> follow(const Shell& shell, Index from) {
    std::map<Index, int> numbers{{from, result_.numbers[from]}};
    std::vector<Index> turned;
    std::size_t facets = 0, against = 0;
    // Borders are few, but for one shell of many regions; each round reaches further.
    for (bool grows = true; grows;) {
      grows = false;
      for (const auto& [nodes, border] : shell) {
        const auto step = border.step();
        if (!step || (*step == 0 && result_.numbers[from] == 0 && (nodes[0] == from || nodes[1] == from)))
          return {};  // a shell listed inside out as well does not tell that what it encloses is empty
        for (const std::size_t end : {0, 1}) {
          const auto known = numbers.find(nodes[end]);
          if (known == numbers.end()) continue;
          const int other = known->second + (end == 0 ? *step : -*step);
          const auto [at, is_new] = numbers.try_emplace(nodes[1 - end], other);
          if (at->second != other) return {};
          grows |= is_new;
        }
      }
    }
    for (const auto& [nodes, border] : shell) {
      facets += border.facets.size();
      for (std::size_t i = 0; i < border.facets.size(); ++i)
        if (border.steps[i] != *border.step()) {
          ++against;
          if (border.steps[i] * *border.step() < 0) turned.push_back(border.facets[i]);
        }
    }
    if (10 * against > facets) return {};
    result_.turned.insert(result_.turned.end(), turned.begin(), turned.end());
    return numbers;
  }

  Index outside_;
  bool by_orientation_ = true, has_contradiction_ = false;
  std::vector<bool> reached_;
  std::vector<std::set<Index>> shells_at_;  // per node
  std::map<Index, Shell> shells_;           // what has not been crossed yet
  Winding result_;
};

}  // namespace

Winding find_winding(const Facets& facets, const std::vector<Sides>& sides, std::size_t regions) {
  Walk walk(facets, sides, regions);
  Winding winding = walk.run(true);
  return walk.has_contradiction() ? Walk(facets, sides, regions).run(false) : winding;
}

}  // namespace multimesh::tetgen
