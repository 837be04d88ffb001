// SPDX-License-Identifier: BSD-3-Clause
// Cutting in dimension 3, in rounds as in dimension 2 (cut.cpp): join across faces, give each class of joined
// corners a vertex, disconnect tetrahedra where different simplices have the same vertices, and repeat.
#include <algorithm>
#include <array>
#include <iterator>
#include <map>

#include "multimesh/cut.hpp"
#include "multimesh/link_surface.hpp"
#include "multimesh/pair_numbers.hpp"
#include "multimesh/tet_sides.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

class TetCutter {
 public:
  explicit TetCutter(const FacetList& in)
      : in_(in), alone_(in.size(), false), parted_(4 * in.size(), false) {}

  Cut run() {
    do {
      join_faces();
      orient();
      part_where_no_orientation_agrees();
      number();
    } while (set_apart());
    return finish();
  }

 private:
  Index tets() const { return static_cast<Index>(in_.size()); }

  std::array<Index, 3> input_corners(Index side) const {
    return side_corners(side, [&](Index c) { return in_.corners[c]; });
  }

  // Joins sides with the same three vertices if there are exactly two.
  void join_faces() {
    partner_.assign(4 * in_.size(), no_index);
    std::vector<Index> here;
    for_each_face(in_, [&](std::span<const Index> sides) {
      here.clear();
      std::copy_if(sides.begin(), sides.end(), std::back_inserter(here),
                   [&](Index s) { return !alone_[s / 4]; });
      if (here.size() != 2 || parted_[here[0]]) return;
      partner_[here[0]] = here[1];
      partner_[here[1]] = here[0];
    });
  }

  void part(Index side) {
    partner_[partner_[side]] = no_index;
    partner_[side] = no_index;
  }

  /// Whether two joined tetrahedra, as given, are oriented alike.
  bool agree(Index side, Index other) const {
    return !is_even(across_sides(side, input_corners(side), other, input_corners(other)));
  }

  // Breadth first, so that a clash lies far from the first tetrahedron of its component.
  void orient() {
    reversed_.assign(in_.size(), false);
    std::vector<bool> seen(in_.size(), false);
    std::vector<Index> queue;
    for (Index start = 0; start < tets(); ++start) {
      if (seen[start]) continue;
      seen[start] = true;
      queue.assign(1, start);
      for (std::size_t i = 0; i < queue.size(); ++i)
        for (Index s = 4 * queue[i]; s < 4 * queue[i] + 4; ++s) {
          const Index other = partner_[s];
          if (other == no_index || seen[other / 4]) continue;
          seen[other / 4] = true;
          reversed_[other / 4] = reversed_[s / 4] != !agree(s, other);
          queue.push_back(other / 4);
        }
    }
  }

  void part_where_no_orientation_agrees() {
    for (Index s = 0; s < partner_.size(); ++s) {
      const Index other = partner_[s];
      if (other > s && other != no_index && agree(s, other) == (reversed_[s / 4] != reversed_[other / 4]))
        part(s);
    }
  }

  // Corners joined across faces are one vertex, numbered by its first corner.
  void number() {
    UnionFind corners(in_.corners.size());
    for (Index s = 0; s < partner_.size(); ++s)
      if (partner_[s] != no_index && partner_[s] > s) {
        const auto from = input_corners(s), to = input_corners(partner_[s]);
        for (std::size_t i = 0; i < 3; ++i) corners.join(from[i], to[i]);
      }
    number_.assign(in_.corners.size(), no_index);
    source_.clear();
    for (Index c = 0; c < number_.size(); ++c) {
      Index& of_class = number_[corners.find(c)];
      if (of_class == no_index) {
        of_class = static_cast<Index>(source_.size());
        source_.push_back(in_.corners[c]);
      }
      number_[c] = of_class;
    }
  }

  bool take_out(Index t) {
    if (alone_[t]) return false;
    alone_[t] = true;
    return true;
  }

  bool set_apart() {
    if (set_double_neighbours_apart()) return true;
    edge_.assign(6 * in_.size(), 0);
    PairNumbers edges(source_.size(), number_);
    for (Index t = 0; t < tets(); ++t)
      for (Index e = 0; e < 6; ++e) edge_[6 * t + e] = edges(end(t, e, 0), end(t, e, 1));
    if (set_faces_apart(edges.size())) return true;
    return set_fans_apart(edges.size()) || set_links_apart(edges.size());
  }

  Index end(Index t, Index e, int i) const { return number_[4 * t + edge_corners[e][i]]; }

  // Two tetrahedra that share more than one face.
  bool set_double_neighbours_apart() {
    bool changed = false;
    for (Index t = 0; t < tets(); ++t)
      for (Index f = 0; f < 4; ++f)
        for (Index g = 0; g < f; ++g) {
          const Index one = partner_[4 * t + f], other = partner_[4 * t + g];
          if (one != no_index && other != no_index && one / 4 == other / 4 && one / 4 < t)
            changed |= take_out(t);
        }
    return changed;
  }

  // Sides with the same vertices that are not joined to each other. A side is named by the edge of its two
  // least vertices, and the third.
  bool set_faces_apart(Index edges) {
    PairNumbers faces(edges + source_.size());
    std::vector<Index> first;
    bool changed = false;
    for (Index s = 0; s < partner_.size(); ++s) {
      const auto c = side_corners(s, [&](Index corner) { return number_[corner]; });
      const Index face = faces(edge_[edge_slot(c[0], c[1])], edges + number_[c[2]]);
      if (face == first.size()) {
        first.push_back(s);
      } else if (partner_[s] != first[face]) {
        changed |= take_out(s / 4);
      }
    }
    return changed;
  }

  // Edges around which the tetrahedra make several fans that no face joins. One fan gets a copy of one end of
  // the edge: the fan for which the fewest faces must be parted. Edges with an end at which another edge has
  // been treated wait for the next round.
  bool set_fans_apart(Index edges) {
    const Fans fans(*this, edges);
    std::vector<bool> treated(source_.size(), false);
    bool changed = false;
    for (const auto& slots : fans.of_pinched_edges()) {
      Index ends[2] = {end(slots[0][0] / 6, slots[0][0] % 6, 0), end(slots[0][0] / 6, slots[0][0] % 6, 1)};
      changed = true;
      if (treated[ends[0]] || treated[ends[1]]) continue;
      treated[ends[0]] = treated[ends[1]] = true;
      part_cheapest_fan(slots, ends);
    }
    return changed;
  }

  /// The fans around each edge that has several, as slots of edges.
  class Fans {
   public:
    Fans(const TetCutter& cutter, Index edges)
        : cutter_(cutter), sets_(cutter.edge_.size()), fans_(edges, 0) {
      join();
      for (Index x = 0; x < cutter_.edge_.size(); ++x) fans_[cutter_.edge_[x]] += sets_.find(x) == x;
    }
    std::vector<std::vector<std::vector<Index>>> of_pinched_edges() const {
      std::map<Index, std::map<Index, std::vector<Index>>> found;  // by edge and fan
      for (Index x = 0; x < cutter_.edge_.size(); ++x)
        if (fans_[cutter_.edge_[x]] > 1) found[cutter_.edge_[x]][sets_.find(x)].push_back(x);
      std::vector<std::vector<std::vector<Index>>> list;
      for (const auto& [edge, fans] : found) {
        list.emplace_back();
        for (const auto& [fan, slots] : fans) list.back().push_back(slots);
      }
      return list;
    }

   private:
    void join() {
      const auto& partner = cutter_.partner_;
      for (Index s = 0; s < partner.size(); ++s) {
        if (partner[s] == no_index || partner[s] < s) continue;
        const auto from = cutter_.input_corners(s), to = cutter_.input_corners(partner[s]);
        for (std::size_t i = 0; i < 3; ++i)
          sets_.join(edge_slot(from[i], from[(i + 1) % 3]), edge_slot(to[i], to[(i + 1) % 3]));
      }
    }
    const TetCutter& cutter_;
    mutable UnionFind sets_;
    std::vector<Index> fans_;  // per edge
  };

  void keep_parted(const std::vector<Index>& sides) {
    for (const Index s : sides) parted_[s] = parted_[partner_[s]] = true;
  }

  void part_cheapest_fan(const std::vector<std::vector<Index>>& fans, const Index (&ends)[2]) {
    std::vector<Index> cheapest, sides;
    for (const auto& slots : fans)
      for (const int i : {0, 1}) {
        sides.clear();
        for (const Index x : slots)
          if (const Index s = corner_at(x / 6, ends[1 - i]); partner_[s] != no_index) sides.push_back(s);
        if (cheapest.empty() || sides.size() < cheapest.size()) cheapest = sides;
      }
    keep_parted(cheapest);
  }

  Index corner_at(Index t, Index v) const {
    const auto first = number_.begin() + 4 * t;
    return static_cast<Index>(std::find(first, first + 4, v) - number_.begin());
  }

  // Vertices whose link is a surface other than a sphere or a disk; links are connected and without pinches
  // by then. By Euler characteristic: the link's vertices are edges at the vertex, its triangles are
  // tetrahedra.
  bool set_links_apart(Index edges) {
    std::vector<long> euler(source_.size(), 0);
    std::vector<bool> rim(source_.size(), false), seen(edges, false);
    std::vector<std::vector<Index>> corners_of_singular;
    for (Index x = 0; x < edge_.size(); ++x)
      if (!seen[edge_[x]]) {
        seen[edge_[x]] = true;
        for (const int i : {0, 1}) euler[end(x / 6, x % 6, i)] += 2;  // counted twice until the end
      }
    for (Index s = 0; s < partner_.size(); ++s)
      for (Index c = s - s % 4; c < s - s % 4 + 4; ++c) {
        if (c == s) {
          euler[number_[c]] += 2;  // the triangle
        } else {
          euler[number_[c]] -= partner_[s] == no_index ? 2 : 1;  // an edge of the link, from this side
          if (partner_[s] == no_index) rim[number_[c]] = true;
        }
      }
    std::vector<Index> list(source_.size(), no_index);
    for (Index c = 0; c < number_.size(); ++c) {
      const Index v = number_[c];
      if (euler[v] == (rim[v] ? 2 : 4)) continue;
      if (list[v] == no_index) {
        list[v] = static_cast<Index>(corners_of_singular.size());
        corners_of_singular.emplace_back();
      }
      corners_of_singular[list[v]].push_back(c);
    }
    for (const auto& corners : corners_of_singular) keep_parted(sides_to_part(link(corners)));
    return !corners_of_singular.empty();
  }

  /// The link of a vertex, given by all its corners, ascending.
  std::vector<LinkTriangle> link(const std::vector<Index>& corners) const {
    std::vector<LinkTriangle> triangles;
    for (const Index c : corners) {
      LinkTriangle& t = triangles.emplace_back();
      std::size_t n = 0;
      for (Index s = c - c % 4; s < c - c % 4 + 4; ++s) {
        if (s == c) continue;
        t.vertices[n] = number_[s];
        t.sides[n] = s;
        t.across[n++] = partner_[s] == no_index ? no_index : triangle_of(corners, partner_[s] / 4);
      }
    }
    return triangles;
  }

  static Index triangle_of(const std::vector<Index>& corners, Index t) {
    return static_cast<Index>(std::lower_bound(corners.begin(), corners.end(), 4 * t) - corners.begin());
  }

  static Index edge_slot(Index corner, Index other) {
    return corner / 4 * 6 + edge_number[corner % 4][other % 4];
  }

  Cut finish() {
    for (std::size_t t = 0; t < in_.size(); ++t)
      if (reversed_[t]) std::swap(number_[4 * t], number_[4 * t + 1]);
    return {{3, static_cast<Index>(source_.size()), std::move(number_)},
            std::move(source_),
            std::move(reversed_)};
  }

  const FacetList& in_;
  std::vector<bool> alone_;     // tetrahedra that are not joined to anything
  std::vector<bool> parted_;    // sides that are not joined, though they could be
  std::vector<Index> partner_;  // of side 4 t + f, opposite corner f: the side it is joined to, or no_index
  std::vector<bool> reversed_;
  std::vector<Index> number_;  // of corner 4 t + i: its new vertex
  std::vector<Index> source_;
  std::vector<Index> edge_;  // of slot 6 t + e: the number of its two vertices
};

}  // namespace

namespace detail {

Cut cut_tetrahedra(const FacetList& facets) {
  return TetCutter(facets).run();
}

}  // namespace detail

}  // namespace multimesh
