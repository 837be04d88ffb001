// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/cut.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

#include "multimesh/error.hpp"
#include "multimesh/pair_numbers.hpp"

namespace multimesh {

namespace detail {
Cut cut_tetrahedra(const FacetList& facets);  // cut_tetrahedra.cpp
}

namespace {

/// Side c of a triangle joins its corners c and next(c).
Index next(Index c) {
  return c % 3 == 2 ? c - 2 : c + 1;
}
Index previous(Index c) {
  return c % 3 == 0 ? c + 2 : c - 1;
}

class Cutter {
 public:
  Cutter(const FacetList& in, const CutOptions& options)
      : in_(in), options_(options), n_(in.corners_per_facet()), alone_(in.size(), false) {}

  Cut run() {
    // Each round disconnects at least one more facet from its neighbours.
    do {
      partner_.assign(in_.corners.size(), no_index);
      reversed_.assign(in_.size(), false);
      in_.dimension == 1 ? join_edges() : join_triangles();
      number();
    } while (set_apart());
    return finish();
  }

 private:
  void join_edges() {
    std::vector<std::array<Index, 2>> at;  // vertex, corner
    for (Index c = 0; c < in_.corners.size(); ++c)
      if (!alone_[c / 2]) at.push_back({in_.corners[c], c});
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0, j; i < at.size(); i = j) {
      for (j = i; j < at.size() && at[j][0] == at[i][0];) ++j;
      if (j - i != 2 || (options_.ends_at && options_.ends_at(at[i][0]))) continue;
      partner_[at[i][1]] = at[i + 1][1];
      partner_[at[i + 1][1]] = at[i][1];
    }
  }

  void join_triangles() {
    neighbours();
    if (!all_agree_) {
      orient();
      part_where_no_orientation_agrees();
    }
  }

  /// Edges have about this many numbers if most have two sides.
  std::size_t expected_edges() const { return in_.corners.size() / 2 + in_.corners.size() / 16; }

  void neighbours() {
    all_joined_ = all_agree_ = true;
    PairNumbers edges(in_.vertices, in_.corners);
    edges.reserve(expected_edges());
    std::vector<Index> first;  // per edge its first side, or no_index if it has three or more
    first.reserve(expected_edges());
    for (Index c = 0; c < in_.corners.size(); ++c) {
      if (alone_[c / 3]) continue;
      const Index e = edges(in_.corners[c], in_.corners[next(c)]);
      if (e == first.size()) {
        first.push_back(c);
      } else {
        add_side(first[e], c);
      }
    }
  }

  void add_side(Index& first, Index c) {
    if (first == no_index) return;
    if (partner_[first] == no_index) {
      partner_[first] = c;
      partner_[c] = first;
      all_agree_ &= !same_direction(first, c);
    } else {
      part(first);
      first = no_index;
    }
  }

  void part(Index c) {
    partner_[partner_[c]] = no_index;
    partner_[c] = no_index;
    all_joined_ = false;
  }

  /// Whether the two sides of an edge run along it in the same direction, as given.
  bool same_direction(Index c, Index d) const { return in_.corners[c] == in_.corners[d]; }

  // Breadth first, so that a clash of orientation lies far from the first facet of its component.
  void orient() {
    std::vector<bool> seen(in_.size(), false);
    std::vector<Index> queue;
    for (Index start = 0; start < in_.size(); ++start) {
      if (seen[start]) continue;
      seen[start] = true;
      queue.assign(1, start);
      for (std::size_t q = 0; q < queue.size(); ++q)
        for (Index c = 3 * queue[q]; c < 3 * queue[q] + 3; ++c) {
          const Index d = partner_[c];
          if (d == no_index || seen[d / 3]) continue;
          seen[d / 3] = true;
          reversed_[d / 3] = reversed_[c / 3] != same_direction(c, d);
          queue.push_back(d / 3);
        }
      turn_the_fewer(queue);
    }
  }

  void turn_the_fewer(const std::vector<Index>& component) {
    const auto turned =
        std::count_if(component.begin(), component.end(), [&](Index f) { return reversed_[f]; });
    if (2 * static_cast<std::size_t>(turned) <= component.size()) return;
    for (const Index f : component) reversed_[f] = !reversed_[f];
  }

  void part_where_no_orientation_agrees() {
    for (Index c = 0; c < partner_.size(); ++c) {
      const Index d = partner_[c];
      if (d != no_index && (reversed_[c / 3] != reversed_[d / 3]) != same_direction(c, d)) part(c);
    }
  }

  // Corners that are joined become one vertex. Vertices are numbered by their first corners.
  void number() {
    number_.assign(in_.corners.size(), no_index);
    source_.clear();
    source_.reserve(std::min<std::size_t>(in_.vertices, in_.corners.size()));
    for (Index c = 0; c < in_.corners.size(); ++c) {
      if (number_[c] != no_index) continue;
      const Index v = static_cast<Index>(source_.size());
      source_.push_back(in_.corners[c]);
      number_[c] = v;
      if (in_.dimension == 2) {
        number_fan(c, c, v);
        number_fan(c, previous(c), v);
      } else if (partner_[c] != no_index) {
        number_[partner_[c]] = v;
      }
    }
  }

  // From corner c on across the side s of its facet, to the end of the fan or once around.
  void number_fan(Index c, Index s, Index v) {
    while (partner_[s] != no_index) {
      const Index across = partner_[s];
      c = (c == s) == same_direction(s, across) ? across : next(across);
      if (number_[c] != no_index) return;
      number_[c] = v;
      s = c == across ? previous(c) : c;
    }
  }

  // After joining, sides with the same vertices at their ends are one edge. That is right for two that run
  // against each other; facets with all vertices in common, and any other sides, must be separated.
  bool set_apart() {
    if (in_.dimension == 2 && all_joined_) return set_pillows_apart();
    if (set_repeated_facets_apart()) return true;
    return in_.dimension == 2 && set_sides_apart();
  }

  bool take_out(Index f) {
    if (alone_[f]) return false;
    alone_[f] = true;
    return true;
  }

  // If all sides are joined in pairs, this is all that can be wrong: a triangle and its reverse.
  bool set_pillows_apart() {
    bool changed = false;
    for (Index f = 0; f < in_.size(); ++f) {
      const Index one = partner_[3 * f], other = partner_[3 * f + 1];
      if (one != no_index && other != no_index && one / 3 == other / 3 && one / 3 < f) changed |= take_out(f);
    }
    return changed;
  }

  // A triangle is named by the edge of its two least vertices, and the third.
  bool set_repeated_facets_apart() {
    bool changed = false;
    const auto take_out_known = [&](PairNumbers& pairs, Index f, Index v, Index w) {
      const Index known = pairs.size();
      if (pairs(v, w) < known) changed |= take_out(f);
    };
    PairNumbers edges(source_.size(), number_);
    if (in_.dimension == 1) {
      for (Index f = 0; f < in_.size(); ++f) take_out_known(edges, f, number_[2 * f], number_[2 * f + 1]);
      return changed;
    }
    std::vector<std::array<Index, 2>> names(in_.size());
    for (Index f = 0; f < in_.size(); ++f) {
      std::array<Index, 3> v{number_[3 * f], number_[3 * f + 1], number_[3 * f + 2]};
      std::sort(v.begin(), v.end());
      names[f] = {edges(v[0], v[1]), v[2]};
    }
    PairNumbers triangles(edges.size() + source_.size());
    for (auto& [edge, vertex] : names) {
      vertex += edges.size();
      triangles.expect(edge);
      triangles.expect(vertex);
    }
    for (Index f = 0; f < in_.size(); ++f) take_out_known(triangles, f, names[f][0], names[f][1]);
    return changed;
  }

  bool set_sides_apart() {
    struct Edge {
      Index first;  // facet
      bool forward, proper;
      int sides;
    };
    PairNumbers numbers(source_.size(), number_);
    std::vector<Edge> edges;
    for (Index c = 0; c < number_.size(); ++c) {
      const Index v = number_[c], w = number_[next(c)];
      const bool forward = (v < w) != reversed_[c / 3];
      const Index e = numbers(v, w);
      if (e == edges.size()) {
        edges.push_back({c / 3, forward, true, 1});
      } else {
        edges[e].proper = ++edges[e].sides == 2 && edges[e].forward != forward;
      }
    }
    bool changed = false;
    for (Index c = 0; c < number_.size(); ++c) {
      const Edge& e = edges[numbers(number_[c], number_[next(c)])];
      if (!e.proper && e.first != c / 3) changed |= take_out(c / 3);
    }
    return changed;
  }

  Cut finish() {
    for (std::size_t f = 0; f < in_.size(); ++f)
      if (reversed_[f]) std::swap(number_[f * n_], number_[f * n_ + 1]);
    return {{in_.dimension, static_cast<Index>(source_.size()), std::move(number_)},
            std::move(source_),
            std::move(reversed_)};
  }

  const FacetList& in_;
  const CutOptions& options_;
  std::size_t n_;
  std::vector<bool> alone_;     // facets that are not joined to anything
  std::vector<Index> partner_;  // of an edge's corner, the other one at its vertex; of a triangle's side, the
                                // other one at its edge; no_index where nothing is joined
  std::vector<bool> reversed_;  // triangles
  bool all_joined_ = true;      // all edges of triangles have one or two sides, and those two are joined
  bool all_agree_ = true;       // and run against each other, as given
  std::vector<Index> number_;   // corners: their new vertex
  std::vector<Index> source_;   // new vertices
};

/// Points share nothing, even if two of them are at one vertex.
Cut cut_points(const FacetList& points) {
  Cut out{
      {0, static_cast<Index>(points.size()), {}}, points.corners, std::vector<bool>(points.size(), false)};
  out.facets.corners.resize(points.size());
  std::iota(out.facets.corners.begin(), out.facets.corners.end(), Index{0});
  return out;
}

}  // namespace

void require_corners(const FacetList& facets, const std::function<std::string(std::size_t)>& name) {
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto v = facets.facet(f);
    for (std::size_t i = 0; i < v.size(); ++i) {
      if (v[i] >= facets.vertices)
        throw InputError(name(f) + " names vertex " + std::to_string(v[i]) + " of " +
                         std::to_string(facets.vertices));
      for (std::size_t j = 0; j < i; ++j)
        if (v[i] == v[j])
          throw InputError(name(f) + " has vertex " + std::to_string(v[i]) + " twice; remove it");
    }
  }
}

Cut cut(const FacetList& facets, const CutOptions& options) {
  if (facets.dimension < 0 || facets.dimension > 3)
    throw InputError("cut: dimension " + std::to_string(facets.dimension) + " is not 0, 1, 2 or 3");
  require_corners(facets, [](std::size_t f) { return "facet " + std::to_string(f); });
  if (facets.dimension == 0) return cut_points(facets);
  return facets.dimension == 3 ? detail::cut_tetrahedra(facets) : Cutter(facets, options).run();
}

}  // namespace multimesh
