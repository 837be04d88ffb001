// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace multimesh::io {

using Point2 = std::array<double, 2>;

/// Twice the signed area of a triangle, positive if it is counter-clockwise.
inline double area2(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// A k-d tree of points in the plane, from which points are removed one by one. Reuses its memory for the
/// next set of points.
class PlaneTree {
 public:
  static constexpr std::uint32_t nothing = ~std::uint32_t{0};

  /// The points must not move. Cost: O(n log n)
  void build(std::span<const Point2> points);
  /// \pre the point is in the tree. Cost: O(log n)
  void remove(std::uint32_t point);

  /// Some point in a counter-clockwise triangle: inside or on its edge from c to a, at none of its corners;
  /// or nothing. Cost: the cells that the triangle meets, O(√n) for thin ones
  std::uint32_t find_in_triangle(const Point2& a, const Point2& b, const Point2& c) const;

 private:
  struct Box {
    Point2 least, most;
  };
  struct Node {
    Box box;
    std::uint32_t begin, end;  ///< in order_
    std::uint32_t left;        ///< and right after it; nothing: a leaf
    std::uint32_t parent;
    std::uint32_t count;  ///< of points that are not removed
  };

  void split(std::uint32_t node);
  Box box_of(std::uint32_t begin, std::uint32_t end) const;

  std::span<const Point2> points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> leaf_;  ///< per point; nothing: removed
  std::vector<Node> nodes_;
  mutable std::vector<std::uint32_t> stack_;
};

}  // namespace multimesh::io
