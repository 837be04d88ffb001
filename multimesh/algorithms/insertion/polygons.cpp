// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/insertion/polygons.hpp"

#include <algorithm>
#include <map>
#include <numeric>

#include "multimesh/geometry/orient2d.hpp"
#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/union_find.hpp"

namespace multimesh::insertion {

namespace {

/// Tests of pairs per triangle of a group; a group that needs more is not merged.
constexpr std::size_t most_pairs = 200;

using Corners = std::array<Index, 3>;

class Grouping {
 public:
  Grouping(std::span<const Vec3> points, const FacetList& triangles, std::span<const std::int32_t> labels)
      : points_(points), triangles_(triangles), labels_(labels), groups_(triangles.size()) {
    for (Index t = 0; t < triangles.size(); ++t) {
      const Corners v = corners(t);
      flat_.push_back(collinear(at(v[0]), at(v[1]), at(v[2])));
    }
  }

  bool is_flat(Index t) const { return flat_[t]; }

  /// Joins neighbours over edges that no third triangle has.
  void join() {
    struct Side {
      Edge edge;
      Index triangle;
    };
    std::vector<Side> sides;
    for (Index t = 0; t < triangles_.size(); ++t) {
      const Corners v = corners(t);
      for (std::size_t i = 0; i < 3; ++i) sides.push_back({undirected(v[i], v[(i + 1) % 3]), t});
    }
    std::ranges::stable_sort(sides, {}, &Side::edge);
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      for (end = i; end < sides.size() && sides[end].edge == sides[i].edge;) ++end;
      if (end - i == 2 && continue_each_other(sides[i].triangle, sides[i + 1].triangle))
        groups_.join(sides[i].triangle, sides[i + 1].triangle);
    }
  }

  /// Groups by their first triangle; those that overlap themselves as single triangles.
  std::vector<std::vector<Index>> groups() {
    std::vector<std::vector<Index>> by_root(triangles_.size()), all;
    for (Index t = 0; t < triangles_.size(); ++t)
      if (!flat_[t]) by_root[groups_.find(t)].push_back(t);
    for (Index t = 0; t < triangles_.size(); ++t) {
      if (flat_[t]) continue;
      auto& group = by_root[groups_.find(t)];
      if (group.empty()) continue;
      if (group.size() == 1 || !overlaps(group)) {
        if (group.front() == t) all.push_back(group);
      } else {
        all.push_back({t});
      }
    }
    return all;
  }

  static Edge undirected(Index a, Index b) { return {std::min(a, b), std::max(a, b)}; }
  Corners corners(Index t) const {
    const auto v = triangles_.facet(t);
    return {v[0], v[1], v[2]};
  }

 private:
  const double* at(Index v) const { return points_[v].data(); }

  /// Along an axis.
  std::array<double, 2> projected(Index v, std::size_t axis) const {
    return {points_[v][(axis + 1) % 3], points_[v][(axis + 2) % 3]};
  }
  int turn(const Corners& v, std::size_t axis) const {
    const auto a = projected(v[0], axis), b = projected(v[1], axis), c = projected(v[2], axis);
    return orient2d(a.data(), b.data(), c.data());
  }
  std::size_t axis_of(const Corners& v) const {
    std::size_t axis = 0;
    while (turn(v, axis) == 0) ++axis;  // not collinear
    return axis;
  }

  /// Whether they lie in one plane, run through their edge in opposite directions, and are not folded.
  bool continue_each_other(Index s, Index t) const {
    if (flat_[s] || flat_[t] || (!labels_.empty() && labels_[s] != labels_[t])) return false;
    const Corners v = corners(s), w = corners(t);
    for (const Index x : w)
      if (orient3d(at(v[0]), at(v[1]), at(v[2]), at(x)) != 0) return false;
    const std::size_t axis = axis_of(v);
    if (turn(v, axis) != turn(w, axis)) return false;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        if (v[i] == w[(j + 1) % 3] && v[(i + 1) % 3] == w[j]) return true;
    return false;
  }

  /// Convex figures have common interior points unless a side of one of them separates them.
  bool overlap(const Corners& v, const Corners& w, std::size_t axis, int sign) const {
    const auto separates = [&](const Corners& by, const Corners& other) {
      for (std::size_t i = 0; i < 3; ++i) {
        const bool beyond = std::ranges::all_of(other, [&](Index x) {
          return sign * turn({by[i], by[(i + 1) % 3], x}, axis) <= 0;
        });
        if (beyond) return true;
      }
      return false;
    };
    return !separates(v, w) && !separates(w, v);
  }

  bool overlaps(const std::vector<Index>& group) {
    const Index root = groups_.find(group.front());
    if (const auto known = overlapping_.find(root); known != overlapping_.end()) return known->second;
    return overlapping_[root] = find_overlap(group);
  }

  bool find_overlap(const std::vector<Index>& group) const {
    const Corners first = corners(group.front());
    const std::size_t axis = axis_of(first);
    const int sign = turn(first, axis);
    struct Box {
      double low[2], high[2];
      Corners v;
    };
    std::vector<Box> boxes;
    for (const Index t : group) {
      const Corners v = corners(t);
      const auto a = projected(v[0], axis), b = projected(v[1], axis), c = projected(v[2], axis);
      Box box{{}, {}, v};
      for (int i = 0; i < 2; ++i)
        box.low[i] = std::min({a[i], b[i], c[i]}), box.high[i] = std::max({a[i], b[i], c[i]});
      boxes.push_back(box);
    }
    std::ranges::sort(boxes, {}, [](const Box& b) { return b.low[0]; });
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low[0] < boxes[i].high[0]; ++j) {
        if (++pairs > most_pairs * boxes.size()) return true;
        if (boxes[j].low[1] >= boxes[i].high[1] || boxes[i].low[1] >= boxes[j].high[1]) continue;
        if (overlap(boxes[i].v, boxes[j].v, axis, sign)) return true;
      }
    return false;
  }

  std::span<const Vec3> points_;
  const FacetList& triangles_;
  std::span<const std::int32_t> labels_;
  UnionFind groups_;
  std::vector<bool> flat_;
  std::map<Index, bool> overlapping_;
};

/// Directed edges without those that occur in both directions.
std::vector<Edge> boundary_of(const std::vector<Index>& group, const Grouping& grouping) {
  std::vector<Edge> edges;
  for (const Index t : group) {
    const Corners v = grouping.corners(t);
    for (std::size_t i = 0; i < 3; ++i) edges.push_back({v[i], v[(i + 1) % 3]});
  }
  if (group.size() == 1) return edges;
  std::ranges::sort(edges);
  std::vector<Edge> boundary;
  for (const Edge& e : edges)
    if (!std::ranges::binary_search(edges, Edge{e[1], e[0]})) boundary.push_back(e);
  return boundary;
}

/// Its triangle of the greatest area.
std::array<Index, 3> plane_of(const std::vector<Index>& group, const Grouping& grouping,
                              std::span<const Vec3> points) {
  double largest = -1;
  std::array<Index, 3> plane{};
  for (const Index t : group) {
    const Corners v = grouping.corners(t);
    const double area = cross(points[v[1]] - points[v[0]], points[v[2]] - points[v[0]]).squared_norm();
    if (area > largest) largest = area, plane = v;
  }
  return plane;
}

}  // namespace

Polygons make_polygons(std::span<const Vec3> points, const FacetList& triangles,
                       std::span<const std::int32_t> labels, bool merge) {
  Grouping grouping(points, triangles, labels);
  if (merge) grouping.join();
  Polygons out;
  std::map<Edge, std::vector<Index>> segments;
  for (std::vector<Index>& group : grouping.groups()) {
    const auto number = static_cast<Index>(out.all.size());
    Polygon p{plane_of(group, grouping, points), boundary_of(group, grouping), {}};
    for (const Edge& e : p.boundary) segments[Grouping::undirected(e[0], e[1])].push_back(number);
    p.triangles = std::move(group);
    out.all.push_back(std::move(p));
  }
  for (Index t = 0; t < triangles.size(); ++t) {
    if (!grouping.is_flat(t)) continue;
    ++out.degenerate;
    const Corners v = grouping.corners(t);
    for (std::size_t i = 0; i < 3; ++i)
      if (v[i] != v[(i + 1) % 3]) segments[Grouping::undirected(v[i], v[(i + 1) % 3])];
  }
  for (auto& [edge, beside] : segments) {
    out.segments.push_back(edge);
    out.beside.push_back(std::move(beside));
  }
  std::vector<std::size_t> order(out.segments.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto length = [&](std::size_t i) {
    return (points[out.segments[i][0]] - points[out.segments[i][1]]).squared_norm();
  };
  std::ranges::stable_sort(order, {}, length);
  Polygons sorted{std::move(out.all), {}, {}, out.degenerate};
  for (const std::size_t i : order) {
    sorted.segments.push_back(out.segments[i]);
    sorted.beside.push_back(std::move(out.beside[i]));
  }
  return sorted;
}

}  // namespace multimesh::insertion
