// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "adapters/io/plane_tree.hpp"

namespace multimesh::io {

/// Ear clipping of one polygon in the plane, counter-clockwise. Reuses its memory for the next polygon. Cost:
/// O(n log n) in practice.
class PolygonClipper {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// \param points the corners in order, at least three.
  /// \param names equal for corners that are the same vertex; a triangle with two equal names is the last
  /// choice. \return n-2 triangles of indices into points, valid until the next call. Each polygon edge is
  /// in one of them.
  std::span<const Triangle> clip(std::span<const Point2> points, std::span<const std::int32_t> names);

 private:
  enum class Rank : std::uint8_t { pinched, inverted, blocked, flat, ear };
  struct Node {
    std::uint32_t before, after;
    std::uint32_t judged;   ///< how often; earlier results are void
    std::uint32_t blocked;  ///< first entry of blocked_ for corners that this one blocks
  };
  /// The triangle (before, self, after) at a corner.
  struct Candidate {
    Rank rank;
    double quality;  ///< its area over its longest edge squared
    std::uint32_t corner, judged;
  };
  struct Blocked {
    std::uint32_t corner, judged;
    std::uint32_t next;
  };

  void link(std::uint32_t count);
  void judge(std::uint32_t i);
  Rank rank_of(std::uint32_t i, double area);
  bool is_blocked(std::uint32_t i);
  std::uint32_t best();
  void cut(std::uint32_t i);

  std::span<const Point2> points_;
  std::span<const std::int32_t> names_;
  std::vector<Node> nodes_;
  std::vector<Candidate> queue_;  ///< a heap
  std::vector<Blocked> blocked_;
  PlaneTree tree_;  ///< of the corners that are not cut off
  std::vector<Triangle> triangles_;
};

}  // namespace multimesh::io
