// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/decimation/placement_test.hpp"

namespace multimesh::decimation {

/// Points of the input, each kept with a triangle of the surface that is near enough. When triangles change,
/// their points must find another one among the triangles that are then around the merged vertex. (The idea of
/// Klein, Liebich, Strasser 1996, for points instead of triangles.)
class PointBound : public PlacementTest {
 public:
  bool allows(const PredictedStar& star, const CollapsePlan& plan) final;
  void collapsed(const PredictedStar& star, const CollapsePlan& plan) final;

 protected:
  PointBound(std::string name, std::size_t triangles)
      : PlacementTest(std::move(name)), first_(triangles, no_index) {}
  void add_point(Index triangle);

  /// How near a triangle would be to a point: points go to the one of the least `order`, whose `distance` must
  /// be within the bound.
  struct Nearness {
    double order, distance;
  };

 private:
  virtual Nearness nearness(Index point, const PredictedStar::Face& after) const = 0;
  virtual bool within_bound(double distance) const = 0;

  struct Move {
    Index point, triangle;
  };
  std::vector<Index> first_;  ///< point of each triangle
  std::vector<Index> next_;   ///< of each point, in its triangle's list
  std::vector<Move> moves_;   ///< of the plan that was allowed last
};

/// No vertex of the input may be farther from the surface than a distance.
class VertexDistance final : public PointBound {
 public:
  VertexDistance(const TexturedSurface& surface, double bound);

 private:
  Nearness nearness(Index point, const PredictedStar::Face& after) const override;
  bool within_bound(double d) const override { return d <= squared_bound_; }

  double squared_bound_;
  std::vector<OpenMesh::Vec3d> points_;
};

/// No vertex of the input's texture may be painted farther from its place than a distance: that between the
/// vertex and where the surface has its texture coordinates now (or, if the chart has shrunk from there, the
/// nearest of that chart).
class TextureDistance final : public PointBound {
 public:
  TextureDistance(const TexturedSurface& surface, const TriangleReader& reader, std::size_t set, double bound);

 private:
  Nearness nearness(Index point, const PredictedStar::Face& after) const override;
  bool within_bound(double d) const override { return d <= squared_bound_; }

  std::size_t set_;
  double squared_bound_;
  struct Point {
    OpenMesh::Vec3d position;
    OpenMesh::Vec2d texcoord;
  };
  std::vector<Point> points_;
};

}  // namespace multimesh::decimation
