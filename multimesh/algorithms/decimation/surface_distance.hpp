// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "multimesh/algorithms/decimation/placement_test.hpp"
#include "multimesh/geometry/triangle_cover.hpp"

namespace multimesh::decimation {

/// No point of the input may be farther from the surface than a distance, and no vertex of the surface
/// farther from the input. (The idea of Klein, Liebich, Strasser 1996; but the distance is only bounded,
/// never computed.)
///
/// Each triangle of the input is stored with its witnesses, triangles of the surface that are near enough to
/// all of it: it can be divided into parts each of which has one of them near its three corners, and so near
/// all of it. When a witness changes, the triangle must find others among those that are then around the
/// merged vertex and those it has elsewhere. A vertex must be near a triangle of the input that has a witness
/// in the old star. If the search for these gives up, the plan is refused.
class SurfaceDistance final : public PlacementTest {
 public:
  /// Cost: linear.
  SurfaceDistance(const TriangleReader& reader, double bound);
  /// Cost: the triangles of the input witnessed in the star, times the size of the star.
  bool allows(const PredictedStar& star, const CollapsePlan& plan) override;
  void collapsed(const PredictedStar& star, const CollapsePlan& plan) override;

 private:
  using Mask = spatial::NearTriangles::Mask;
  struct Vertex {
    Vec3 position;
    std::uint64_t plan = 0;  ///< the number of the plan to which `near` belongs
    spatial::NearTriangles::Near near;
  };
  struct InputTriangle {
    std::array<Index, 3> vertices;
    std::uint64_t plan = 0;  ///< the number of the last plan that searched for witnesses
  };
  struct Move {
    Index input;
    spatial::Witnesses::Set witnesses;
  };

  void read_candidates(const PredictedStar& star);
  bool find_witnesses(const PredictedStar& star);
  bool find_one(Index input);
  bool find_several(const PredictedStar& star, Index input);
  void add_witnesses_elsewhere(const PredictedStar& star, Index input);
  bool is_near_input(const PredictedStar& star, const Vec3& position) const;

  const spatial::NearTriangles::Near& near(Vertex& v);

  const TriangleReader& reader_;
  const Mesh& mesh_;
  double squared_bound_;
  std::vector<Vertex> vertices_;  ///< of the input
  std::vector<InputTriangle> triangles_;
  spatial::Witnesses witnesses_;

  // Of the plan that was asked about last:
  std::uint64_t plan_ = 0;  ///< its number
  spatial::NearTriangles candidates_;
  std::size_t in_star_ = 0;       ///< the first of the candidates: those around the merged vertex
  std::vector<Index> undecided_;  ///< triangles of the input that may need several witnesses
  std::vector<Move> moves_;
};

}  // namespace multimesh::decimation
