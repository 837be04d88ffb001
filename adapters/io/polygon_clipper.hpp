// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace multimesh::io {

using Point2 = std::array<double, 2>;

/// Ear clipping of one polygon in the plane, counter-clockwise. Keeps its memory from one polygon to the
/// next.
class PolygonClipper {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// \param points the corners in order, at least three.
  /// \param names equal for corners that are the same vertex; a triangle with two equal names is the last
  /// choice. \return n-2 triangles of indices into points, valid until the next call. Each polygon edge is in
  /// one of them.
  std::span<const Triangle> clip(std::span<const Point2> points, std::span<const std::int32_t> names);

 private:
  enum class Rank : std::uint8_t { pinched, inverted, blocked, flat, ear };
  struct Node {
    std::uint32_t before, after;
    Rank rank;
    double quality;  ///< of the triangle (before, self, after): area over longest edge squared
  };

  void link(std::uint32_t count);
  void judge(std::uint32_t i);
  Rank rank_of(std::uint32_t i, double area) const;
  bool is_blocked(std::uint32_t i) const;
  std::uint32_t best();
  void cut(std::uint32_t i);

  std::span<const Point2> points_;
  std::span<const std::int32_t> names_;
  std::vector<Node> nodes_;
  std::vector<Triangle> triangles_;
  std::uint32_t first_ = 0;  ///< some corner that is not cut off yet
  std::uint32_t left_ = 0;
};

}  // namespace multimesh::io
