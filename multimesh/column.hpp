// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "multimesh/attribute.hpp"
#include "multimesh/value_list.hpp"

namespace multimesh {

// clang-format off
/// How each operation changes the values of a column. Without a function, the value stays as it is.
///
///        b                b           b        Collapse of a into b: l-a and l-b become one edge, r-a and r-b too.
///       /|\              / \         /|\       Of the two values, the one that is kept is that of the edge in a
///      / | \   swap     /   \       / c \      curve below, if the other is in none, else that at b.
///     l  |  r   ->    l-----r     l--|--r      Split: a-c and c-b are halves of a-b; c-l and c-r are fresh. Facets
///      \ | /            \   /       \ | /      a-c-l and c-b-l are halves of a-b-l.
///       \|/              \ /         \|/       Swap: l-r is fresh. The facet that has a before b in its own order
///        a                a           a        keeps its value as the one at a; the other is the one at b.
///
/// A corner stays with its facet: the halves of a-b-l have the corners of the whole, with c's for b's or a's; in a
/// collapse b has the corner of a in the facets that had a; in a swap l and r take theirs along. A swap in a tree with
/// tetrahedra is a split, and a collapse of c into l that changes nothing at l.
// clang-format on
template <class T>
struct ColumnRules {
  /// Collapse: merges the value that is kept with the other; (1-share) and share are their parts of the
  /// merged simplex.
  std::function<T(const T& kept, const T& other, double share)> merge{};
  /// Split: the value of a half that is this share of the whole. For corners, see `between`.
  std::function<T(const T& whole, double share)> halve{};
  /// Swap: the value of a facet, from its own and the other's; of the new edge, from the old value twice.
  std::function<T(const T& own, const T& other)> swap{};
  /// Split: the value of the corner at a new vertex (1-t) a + t b of a facet, from those at a and at b.
  std::function<T(const T& a, const T& b, double t)> between{};
  /// The value of a new edge that is not a half of another.
  T fresh = initial_value<T>();
  /// Whether `merge` gives the same whichever of the two values is kept: then that is not found out.
  bool symmetric = false;

  /// Flags: the merged simplex has those of both.
  static ColumnRules unite() {
    return {.merge = [](const T& x, const T& y, double) { return T(x | y); }, .symmetric = true};
  }
  static ColumnRules larger() {
    return {.merge = [](const T& x, const T& y, double) { return std::max(x, y); }, .symmetric = true};
  }
  static ColumnRules smaller() {
    return {.merge = [](const T& x, const T& y, double) { return std::min(x, y); }, .symmetric = true};
  }
  /// Values of the end nearer to the merged vertex count more; likewise for the corners of a new vertex.
  static ColumnRules interpolate() { return {.merge = interpolated<T>, .between = interpolated<T>}; }
};

/// Values on the simplices of one dimension k > 0 of a mesh, or on its corners, that follow the operations by
/// rules. \pre Mesh::stores(k), or Mesh::corner: an edge of a tetrahedral mesh has no lasting index (use
/// tet::SimplexProperty there). The mesh itself must not modify the vector.
template <class T>
class Column final : public ValueAttribute<T> {
 public:
  Column(NodeId node, int k, std::vector<T>& values, ColumnRules<T> rules = {})
      : ValueAttribute<T>(node, k, values), rules_(std::move(rules)) {
    if (k == 0) throw UsageError("values on vertices are a VertexAttribute, not a Column");
  }

  bool needs_kept() const override { return !rules_.symmetric; }
  void update(Operation, const VertexChange&) override {}
  void finish(const Event& event) override {
    if (this->dimension() == corners) return move_corners(event);
    for (const SimplexChange& c : event.changes->simplices)
      if (c.node == this->node() && c.k == this->dimension()) apply(c, event.t);
  }

 private:
  void apply(const SimplexChange& c, double t) {
    const T first = (*this)[c.first], second = (*this)[c.second == no_index ? c.first : c.second];
    switch (c.kind) {
      case SimplexChange::Kind::halved:
        return halve(c, t);
      case SimplexChange::Kind::merged:
        if (rules_.merge) {
          this->set(c.first, c.second_wins ? rules_.merge(second, first, 1 - c.share)
                                           : rules_.merge(first, second, c.share));
        } else if (c.second_wins) {
          this->set(c.first, second);
        }
        return;
      case SimplexChange::Kind::fresh:
        return this->set(c.first, rules_.fresh);
      case SimplexChange::Kind::swapped:
        if (rules_.swap) {
          this->set(c.first, rules_.swap(first, second));
          if (c.second != c.first) this->set(c.second, rules_.swap(second, first));
        } else if (c.second == c.first) {
          this->set(c.first, rules_.fresh);
        }
    }
  }
  void halve(const SimplexChange& c, double t) {
    const T whole = (*this)[c.whole];
    this->set(c.first, rules_.halve ? rules_.halve(whole, t) : whole);
    this->set(c.second, rules_.halve ? rules_.halve(whole, 1 - t) : whole);
  }

  void move_corners(const Event& event) {
    const std::vector<CornerChange>& all = event.changes->corners;
    for (std::size_t i = 0, end = 0; i < all.size(); i = end) {
      for (end = i; end < all.size() && all[end].copy == all[i].copy; ++end) {
      }
      if (all[i].node != this->node()) continue;
      moved_.clear();
      for (std::size_t j = i; j < end; ++j) moved_.push_back(moved(all[j], event.t));
      for (std::size_t j = i; j < end; ++j) this->set(all[j].to, moved_[j - i]);
    }
  }
  T moved(const CornerChange& c, double t) const {
    if (c.a == no_index || !rules_.between) return (*this)[c.from];
    return rules_.between((*this)[c.a], (*this)[c.b], t);
  }

  ColumnRules<T> rules_;
  std::vector<T> moved_;
};

}  // namespace multimesh
