// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/decimation/placement_test.hpp"

namespace multimesh::decimation {

/// No vertex of the input's texture may be drawn farther from its place than a distance: that between the
/// vertex and where the surface has its texture coordinates now (or, if the chart has shrunk from there, the
/// nearest of that chart). Each is stored with a triangle of the surface that draws it near enough. When
/// triangles change, their vertices must find another one among those that are then around the merged vertex.
/// (The idea of Klein, Liebich, Strasser 1996, for points instead of triangles.)
class TextureDistance final : public PlacementTest {
 public:
  TextureDistance(const TriangleReader& reader, std::size_t set, double bound);
  bool allows(const PredictedStar& star, const CollapsePlan& plan) override;
  void collapsed(const PredictedStar& star, const CollapsePlan& plan) override;

 private:
  struct Point {
    Vec3 position;
    Vec2 texcoord;
    Index next;  ///< in its triangle's list
  };
  /// How near a triangle would be to a point: in the texture, and in space where it draws the point.
  struct Nearness {
    double in_texture, in_space;  ///< squared
  };
  struct Move {
    Index point, triangle;
  };

  void add_point(const SurfaceTriangle& t, std::size_t corner);
  bool find_triangle(const PredictedStar& star, Index point);
  Nearness nearness(const Point& point, const PredictedStar::Face& after) const;

  std::size_t set_;
  double squared_bound_;
  std::vector<Point> points_;
  std::vector<Index> first_;  ///< point of each triangle
  std::vector<Move> moves_;   ///< of the plan that was allowed last
};

}  // namespace multimesh::decimation
