// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/cut.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "multimesh/error.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh {

namespace {

/// One side of a facet. In a triangle, side i joins corners i and i+1.
struct Side {
  std::uint64_t key;  // as key_of gives it
  Index facet;
  std::uint8_t corner;
  friend bool operator<(const Side& x, const Side& y) {
    return x.key != y.key ? x.key < y.key : x.facet < y.facet;
  }
};

/// Two vertices in any order, as one word: comparing arrays calls memcmp.
std::uint64_t key_of(Index v, Index w) {
  return std::uint64_t{std::min(v, w)} << 32 | std::max(v, w);
}

class Cutter {
 public:
  Cutter(const FacetList& in, const CutOptions& options)
      : in_(in), options_(options), n_(in.corners_per_facet()), alone_(in.size(), false) {}

  Cut run() {
    refuse_degenerate();
    // Each round takes at least one more facet out of its neighbourhood.
    do {
      join();
    } while (set_apart());
    return number();
  }

 private:
  void refuse_degenerate() const {
    for (std::size_t f = 0; f < in_.size(); ++f) {
      const auto v = in_.facet(f);
      for (std::size_t i = 0; i < n_; ++i) {
        if (v[i] >= in_.vertices)
          throw InputError("facet " + std::to_string(f) + " names vertex " + std::to_string(v[i]) + " of " +
                           std::to_string(in_.vertices));
        for (std::size_t j = 0; j < i; ++j)
          if (v[i] == v[j])
            throw InputError("facet " + std::to_string(f) + " has vertex " + std::to_string(v[i]) +
                             " twice; remove the degenerate facet");
      }
    }
  }

  Index corner(Index f, std::size_t i) const { return static_cast<Index>(f * n_ + i % n_); }
  Index vertex(Index f, std::size_t i) const { return in_.corners[corner(f, i)]; }

  void join() {
    classes_ = UnionFind(in_.corners.size());
    reversed_.assign(in_.size(), false);
    in_.dimension == 1 ? join_edges() : join_triangles();
  }

  void join_edges() {
    std::vector<std::array<Index, 2>> at;  // vertex, corner
    for (Index c = 0; c < in_.corners.size(); ++c)
      if (!alone_[c / 2]) at.push_back({in_.corners[c], c});
    std::sort(at.begin(), at.end());
    for (std::size_t i = 0, j; i < at.size(); i = j) {
      for (j = i; j < at.size() && at[j][0] == at[i][0];) ++j;
      if (j - i == 2 && !(options_.ends_at && options_.ends_at(at[i][0])))
        classes_.join(at[i][1], at[i + 1][1]);
    }
  }

  void join_triangles() {
    neighbours();
    orient();
    for (Index f = 0; f < in_.size(); ++f)
      for (std::size_t i = 0; i < 3; ++i) {
        const Across x = across_[corner(f, i)];
        if (x.facet == no_index || agrees(f, x) == false) continue;
        classes_.join(corner(f, i), corner(x.facet, x.corner + (x.same_direction ? 0U : 1U)));
        classes_.join(corner(f, i + 1), corner(x.facet, x.corner + (x.same_direction ? 1U : 0U)));
      }
  }

  struct Across {
    Index facet = no_index;
    std::uint8_t corner = 0;
    bool same_direction = false;  // both run along the side in the same direction, as given
  };
  bool agrees(Index f, const Across& x) const {
    return (reversed_[f] != reversed_[x.facet]) == x.same_direction;
  }

  void neighbours() {
    std::vector<Side> sides;
    sides.reserve(in_.corners.size());
    for (Index f = 0; f < in_.size(); ++f)
      if (!alone_[f])
        for (std::uint8_t i = 0; i < 3; ++i) {
          const Index v = vertex(f, i), w = vertex(f, i + 1U);
          sides.push_back({key_of(v, w), f, i});
        }
    std::sort(sides.begin(), sides.end());
    across_.assign(in_.corners.size(), {});
    for (std::size_t i = 0, j; i < sides.size(); i = j) {
      for (j = i; j < sides.size() && sides[j].key == sides[i].key;) ++j;
      if (j - i != 2) continue;
      const Side &s = sides[i], &t = sides[i + 1];
      const bool same = vertex(s.facet, s.corner) == vertex(t.facet, t.corner);
      across_[corner(s.facet, s.corner)] = {t.facet, t.corner, same};
      across_[corner(t.facet, t.corner)] = {s.facet, s.corner, same};
    }
  }

  // Breadth first, so that a clash of orientation lies far from the first facet of its component.
  void orient() {
    std::vector<bool> seen(in_.size(), false);
    std::vector<Index> queue;
    for (Index start = 0; start < in_.size(); ++start) {
      if (seen[start]) continue;
      seen[start] = true;
      queue.assign(1, start);
      for (std::size_t q = 0; q < queue.size(); ++q)
        for (std::size_t i = 0; i < 3; ++i) {
          const Across x = across_[corner(queue[q], i)];
          if (x.facet == no_index || seen[x.facet]) continue;
          seen[x.facet] = true;
          reversed_[x.facet] = reversed_[queue[q]] != x.same_direction;
          queue.push_back(x.facet);
        }
    }
  }

  // After joining, sides with the same classes at their ends are one edge. That is right for two that run
  // against each other; facets with all vertices in common, and any other sides, must come apart.
  bool set_apart() {
    bool changed = false;
    const auto take_out = [&](Index f) {
      if (!alone_[f]) alone_[f] = changed = true;
    };
    std::vector<std::pair<std::array<Index, 3>, Index>> facets;
    for (Index f = 0; f < in_.size(); ++f) {
      std::array<Index, 3> key{no_index, no_index, no_index};
      for (std::size_t i = 0; i < n_; ++i) key[i] = classes_.find(corner(f, i));
      std::sort(key.begin(), key.end());
      facets.emplace_back(key, f);
    }
    std::sort(facets.begin(), facets.end());
    for (std::size_t i = 1; i < facets.size(); ++i)
      if (facets[i].first == facets[i - 1].first) take_out(facets[i].second);
    if (in_.dimension == 1 || changed) return changed;

    std::vector<Side> sides;
    for (Index f = 0; f < in_.size(); ++f)
      for (std::uint8_t i = 0; i < 3; ++i) {
        const Index v = classes_.find(corner(f, i)), w = classes_.find(corner(f, i + 1U));
        const bool forward = (v < w) != reversed_[f];
        sides.push_back({key_of(v, w), f, static_cast<std::uint8_t>(forward)});
      }
    std::sort(sides.begin(), sides.end());
    for (std::size_t i = 0, j; i < sides.size(); i = j) {
      for (j = i; j < sides.size() && sides[j].key == sides[i].key;) ++j;
      if (j - i == 1 || (j - i == 2 && sides[i].corner != sides[i + 1].corner)) continue;
      for (std::size_t m = i + 1; m < j; ++m) take_out(sides[m].facet);
    }
    return changed;
  }

  Cut number() {
    Cut out{{in_.dimension, 0, std::vector<Index>(in_.corners.size())}, {}, reversed_};
    std::vector<Index> number(in_.corners.size(), no_index);
    for (Index f = 0; f < in_.size(); ++f)
      for (std::size_t i = 0; i < n_; ++i) {
        Index& id = number[classes_.find(corner(f, i))];
        if (id == no_index) {
          id = out.facets.vertices++;
          out.source.push_back(vertex(f, i));
        }
        const std::size_t position = reversed_[f] && i < 2 ? 1 - i : i;
        out.facets.corners[f * n_ + position] = id;
      }
    return out;
  }

  const FacetList& in_;
  const CutOptions& options_;
  std::size_t n_;
  std::vector<bool> alone_;  // facets that are joined to nothing
  UnionFind classes_{0};     // of corners that become one vertex
  std::vector<Across> across_;
  std::vector<bool> reversed_;
};

}  // namespace

Cut cut(const FacetList& facets, const CutOptions& options) {
  if (facets.dimension < 1 || facets.dimension > 2)
    throw InputError("cut: dimension " + std::to_string(facets.dimension) + " is not 1 or 2");
  return Cutter(facets, options).run();
}

}  // namespace multimesh
