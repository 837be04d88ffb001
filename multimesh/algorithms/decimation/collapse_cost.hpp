// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "multimesh/algorithms/decimation/deviation_form.hpp"
#include "multimesh/algorithms/decimation/predicted_star.hpp"

namespace multimesh::decimation {

/// What collapsing an edge costs, and the best place for the merged vertex.
///
/// The cost is the squared deviation of the merged vertex from the current triangles around both ends, each
/// weighted by a third of its area: the distance to the triangle's plane and, weighted by `uv_weight`, the
/// distance along it between the vertex and where the texture has its content (the texture deviation of
/// Cohen, Olano, Manocha 1998, with the texture continued affinely). It is quadratic in position and texture
/// coordinates together (Garland & Heckbert 1998; Hoppe 1999), and measures lengths in space only: no weight
/// depends on the scale of the model or of its texture. Memoryless (Lindstrom & Turk 1998): a vertex of the
/// current surface deviates by nothing, so its form has no linear part, and what is stored per vertex is the
/// sum over its triangles. Curves add planes through their edges.
///
/// Without memory, thin parts could be consumed in many small steps, none of which costs much. So the
/// distance from the planes of the input that were merged into a vertex (Garland & Heckbert 1997) also
/// counts, weighted by `memory_weight`.
class CollapseCost {
 public:
  /// Cost: linear.
  CollapseCost(const DecimateOptions& options, const Ranks& ranks, const TriangleReader& reader);

  /// The best plan; nothing if the ranks of the ends show that no collapse of this edge is legal.
  std::optional<CollapsePlan> plan(Dart e) const;
  /// The same, written to the caller's plan; false if there is none.
  bool plan(Dart e, CollapsePlan& plan) const;
  /// The plan that puts the merged vertex on the edge, at (1-t) a + t b.
  CollapsePlan plan_at(Dart e, double t) const;

  /// Updates the forms after the collapse that `star` predicted, by this plan.
  void collapsed(const PredictedStar& star, const CollapsePlan& plan, End kept);

 private:
  struct Shape;
  struct Edge;

  void start(Dart e, CollapsePlan& plan) const;
  void put_at(Dart e, double t, CollapsePlan& plan) const;
  void find_copies(Dart e, CollapsePlan& plan) const;
  void find_sheets(Dart e, CollapsePlan& plan) const;
  struct Quadratic;
  double deviation(const CollapsePlan& plan) const {
    return plan.other_sheets.empty() ? deviation_of<false>(plan) : deviation_of<true>(plan);
  }
  template <bool other_sheets>
  double deviation_of(const CollapsePlan& plan) const;
  template <bool other_sheets>
  inline Quadratic quadratic(const CollapsePlan& plan, const Vec3& half) const;
  template <bool other_sheets>
  void minimize_over(CollapsePlan& plan) const;
  void minimize(CollapsePlan& plan) const;
  void stay_in_sides(const CollapsePlan& plan, Quadratic& q) const;
  void add(const SurfaceTriangle& t, double sign);
  void add_curves(const SurfaceTriangle& t, const Shape& shape, double sign);
  void remember(const SurfaceTriangle& t);
  void note_copies(const SurfaceTriangle& t);
  void replace_triangles(const PredictedStar& star, const CollapsePlan& plan, End kept);

  const DecimateOptions& options_;
  const MultiMesh& tree_;
  const Mesh& mesh_;
  const Ranks& ranks_;
  const TriangleReader& reader_;
  const std::vector<Vec3>& positions_;
  bool is_periodic_;
  std::vector<PositionForm> position_forms_;  ///< per vertex of the surface
  /// A power of two, so that multiplying by it and its powers is exact.
  struct Unit {
    explicit Unit(double l)
        : length(l), per_square(1 / (l * l)), per_cube(per_square / l), per_4th(per_square * per_square) {}
    double length, per_square, per_cube, per_4th;
  };
  Unit memory_unit_{1};             ///< lengths are multiplied by it there, so that the surface has size 1
  std::vector<PlanesForm> memory_;  ///< as the position forms; empty if its weight is 0
  struct Set {
    NodeId node;
    const std::vector<Vec2>& texcoords;
    std::vector<TextureForm> forms;  ///< per vertex of the texture
    std::vector<Index> only_copy;    ///< per vertex of the surface: its one copy here, if it has just one
  };
  static constexpr Index several_copies = no_index - 1;
  std::vector<Set> sets_;
  mutable DartBuffer found_, sheets_;
};

}  // namespace multimesh::decimation
