// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/geometry/closest_point.hpp"

namespace multimesh::spatial {

/// A binary tree of boxes around triangles, in double precision: neither its results nor its speed depend on
/// how far apart the triangles lie.
class BoxTree {
 public:
  /// Cost: O(n log n); about 40 bytes per triangle. \pre triangles are finite
  explicit BoxTree(const std::vector<Triangle>& triangles);

  /// Calls visit(facet) for all triangles that may be within a distance of p, near ones first. visit returns
  /// the square of that distance, which may shrink.
  template <class Visit>
  void visit_near(const Vec3& p, double squared_distance, Visit visit) const {
    if (nodes_.empty()) return;
    struct Pending {
      Index node;
      double squared_distance;
    };
    std::array<Pending, 64> stack;  // deeper than any tree: each child has half of the triangles
    std::size_t size = 0;
    stack[size++] = {0, squared_distance_to(nodes_[0], p)};
    while (size > 0) {
      const Pending next = stack[--size];
      const Node* node = &nodes_[next.node];
      if (is_beyond(*node, next.squared_distance, p, squared_distance)) continue;
      if (node->count > 0) {
        for (Index i = node->first; i < node->first + node->count; ++i) squared_distance = visit(order_[i]);
        continue;
      }
      Pending left{next.node + 1, squared_distance_to(node[1], p)};
      Pending right{node->first, squared_distance_to(nodes_[node->first], p)};
      if (left.squared_distance < right.squared_distance) std::swap(left, right);
      stack[size++] = left;
      stack[size++] = right;
    }
  }

 private:
  struct Node {
    Vec3 low, high;
    Index first;  ///< of a leaf: in order_; else the second child (the first child comes next)
    Index count;  ///< of a leaf: triangles; else 0
  };

  struct Item {
    Vec3 middle;
    Index facet;
  };
  void build(const std::vector<Triangle>& triangles, Item* begin, Item* end);

  static double squared_distance_to(const Node& n, const Vec3& p) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double below = n.low[i] - p[i], above = p[i] - n.high[i];
      const double d = below > 0 ? below : above > 0 ? above : 0;
      sum += d * d;
    }
    return sum;
  }

  // Computed distances have rounding errors relative to the distance to the farthest corner.
  static bool is_beyond(const Node& n, double box, const Vec3& p, double least) {
    if (!(box > least)) return false;
    double far = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = p[i] - n.low[i], b = n.high[i] - p[i];
      const double d = a > b ? a : b;
      far += d * d;
    }
    constexpr double rounding = 1e-14;
    return box > least + rounding * far;
  }

  std::vector<Node> nodes_;
  std::vector<Index> order_;
};

}  // namespace multimesh::spatial
