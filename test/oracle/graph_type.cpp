// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/graph_type.hpp"

#include <algorithm>
#include <array>

#include "oracle/disjoint_sets.hpp"

namespace multimesh::oracle {

std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
  std::uint64_t x = hash * 0x9e3779b97f4a7c15ULL + value + 0x632be59bd9b4e019ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

namespace {

struct HalfArc {
  std::uint64_t label;
  std::size_t target;  // essential vertex at the other end
};

/// The smoothed multigraph. Every arc is two half-arcs, one at each end.
struct Smoothed {
  std::vector<std::uint64_t> label;        // of each essential vertex
  std::vector<std::vector<HalfArc>> arcs;  // at each essential vertex
  std::vector<std::uint64_t> loops;        // label of each closed curve
};

class Smoother {
 public:
  explicit Smoother(const LabelledGraph& graph) : graph_(graph), visited_(graph.edges.size(), 0) {
    for (const auto& [vertex, label] : graph.vertices) {
      ids_.push_back(vertex);
      labels_.push_back(label);
    }
    at_.resize(ids_.size());
    for (std::size_t e = 0; e < graph.edges.size(); ++e) {
      ends_.push_back({index(graph.edges[e].from), index(graph.edges[e].to)});
      for (std::size_t v : ends_.back()) at_[v].push_back(e);
    }
  }

  Smoothed run() {
    std::vector<std::size_t> essential(ids_.size(), kNone);
    for (std::size_t v = 0; v < ids_.size(); ++v) {
      if (ordinary(v)) continue;
      essential[v] = result_.label.size();
      result_.label.push_back(labels_[v]);
    }
    result_.arcs.resize(result_.label.size());
    for (std::size_t v = 0; v < ids_.size(); ++v) {
      if (essential[v] == kNone) continue;
      for (std::size_t e : at_[v]) {
        const std::size_t end = essential[walk(v, e)];
        result_.arcs[essential[v]].push_back({graph_.edges[e].label, end});
      }
    }
    collect_loops();
    return std::move(result_);
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  std::size_t index(int vertex) const {
    return static_cast<std::size_t>(std::lower_bound(ids_.begin(), ids_.end(), vertex) - ids_.begin());
  }

  bool ordinary(std::size_t v) const {
    if (at_[v].size() != 2) return false;
    const LabelledEdge& e = graph_.edges[at_[v][0]];
    return e.label == graph_.edges[at_[v][1]].label && labels_[v] == e.ordinary;
  }

  /// Follows the arc that leaves v along edge e, to the next essential vertex (or back to v).
  std::size_t walk(std::size_t v, std::size_t e) {
    const std::size_t start = v;
    do {
      visited_[e] = 1;
      v = ends_[e][0] == v ? ends_[e][1] : ends_[e][0];
      if (!ordinary(v)) break;
      e = at_[v][0] == e ? at_[v][1] : at_[v][0];
    } while (v != start);
    return v;
  }

  void collect_loops() {
    for (std::size_t e = 0; e < visited_.size(); ++e) {
      if (visited_[e]) continue;
      result_.loops.push_back(graph_.edges[e].label);
      walk(ends_[e][0], e);
    }
  }

  const LabelledGraph& graph_;
  std::vector<char> visited_;
  std::vector<int> ids_;
  std::vector<std::uint64_t> labels_;
  std::vector<std::array<std::size_t, 2>> ends_;
  std::vector<std::vector<std::size_t>> at_;
  Smoothed result_;
};

std::vector<std::uint64_t> refine(const Smoothed& graph, const std::vector<std::uint64_t>& colour) {
  std::vector<std::uint64_t> next(colour.size());
  std::vector<std::uint64_t> around;
  for (std::size_t v = 0; v < colour.size(); ++v) {
    around.clear();
    for (const HalfArc& arc : graph.arcs[v]) around.push_back(mix(arc.label, colour[arc.target]));
    std::sort(around.begin(), around.end());
    next[v] = colour[v];
    for (std::uint64_t h : around) next[v] = mix(next[v], h);
  }
  return next;
}

std::size_t number_of_colours(std::vector<std::uint64_t> colour) {
  std::sort(colour.begin(), colour.end());
  return static_cast<std::size_t>(std::unique(colour.begin(), colour.end()) - colour.begin());
}

/// Refines until the partition does not get finer; at least once.
std::vector<std::uint64_t> stable(const Smoothed& graph, std::vector<std::uint64_t> colour) {
  std::size_t before = number_of_colours(colour);
  while (true) {
    colour = refine(graph, colour);
    const std::size_t after = number_of_colours(colour);
    if (after == before) return colour;
    before = after;
  }
}

/// Hash of the colours in the component with representative r.
std::uint64_t component_hash(const std::vector<std::uint64_t>& colour, const DisjointSets& sets,
                             std::size_t r) {
  std::vector<std::uint64_t> colours;
  for (std::size_t v = 0; v < colour.size(); ++v) {
    if (sets.find(v) == r) colours.push_back(colour[v]);
  }
  std::sort(colours.begin(), colours.end());
  std::uint64_t hash = colours.size();
  for (std::uint64_t c : colours) hash = mix(hash, c);
  return hash;
}

/// Stable colours; where several vertices share one, each is told apart by what its component looks like when
/// it alone is marked.
std::vector<std::uint64_t> individualized(const Smoothed& graph, const DisjointSets& sets) {
  const std::vector<std::uint64_t> colour = stable(graph, graph.label);
  std::vector<std::uint64_t> result = colour;
  for (std::size_t v = 0; v < colour.size(); ++v) {
    if (std::count(colour.begin(), colour.end(), colour[v]) == 1) continue;
    std::vector<std::uint64_t> marked = colour;
    marked[v] = mix(marked[v], 1);
    result[v] = mix(colour[v], component_hash(stable(graph, marked), sets, sets.find(v)));
  }
  return result;
}

/// (essential vertices, half-arcs, hash) of the component with representative r.
std::array<std::int64_t, 3> component_type(const Smoothed& graph, const std::vector<std::uint64_t>& colour,
                                           const DisjointSets& sets, std::size_t r) {
  std::int64_t essential = 0;
  std::int64_t half_arcs = 0;
  for (std::size_t v = 0; v < colour.size(); ++v) {
    if (sets.find(v) != r) continue;
    ++essential;
    half_arcs += static_cast<std::int64_t>(graph.arcs[v].size());
  }
  return {essential, half_arcs, static_cast<std::int64_t>(component_hash(colour, sets, r))};
}

}  // namespace

Signature graph_type(const LabelledGraph& graph) {
  Smoothed smooth = Smoother(graph).run();
  DisjointSets sets(smooth.label.size());
  for (std::size_t v = 0; v < smooth.label.size(); ++v) {
    for (const HalfArc& arc : smooth.arcs[v]) sets.join(v, arc.target);
  }
  const std::vector<std::uint64_t> colour = individualized(smooth, sets);
  std::vector<std::array<std::int64_t, 3>> components;
  for (std::size_t v = 0; v < colour.size(); ++v) {
    if (sets.find(v) == v) components.push_back(component_type(smooth, colour, sets, v));
  }
  std::sort(components.begin(), components.end());
  std::sort(smooth.loops.begin(), smooth.loops.end());
  Signature words{static_cast<std::int64_t>(components.size())};
  for (const auto& c : components) words.insert(words.end(), c.begin(), c.end());
  for (std::uint64_t label : smooth.loops) words.push_back(static_cast<std::int64_t>(label));
  return words;
}

}  // namespace multimesh::oracle
