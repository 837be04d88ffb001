// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/improvement/workspace.hpp"

namespace multimesh::improvement {

/// What the held faces and curves of a domain force on any mesh of it: a tetrahedron in each angle between
/// two faces around an edge, and one with a face in each corner of a face between two edges that are creases.
class Obstacles {
 public:
  /// Cost: a ring per edge on held faces
  Obstacles(const Workspace& work, SurfaceSplits splits);

  /// The greatest lower bound of the AMIPS energy, and a point that forces it.
  double bound() const { return bound_; }
  const Vec3& place() const { return place_; }
  /// The bound that is forced at a vertex; 3 if there is none, or if the vertex is new.
  double bound_at(Index v) const { return v < forced_.size() ? forced_[v].bound : 3; }

  /// The live tetrahedra above the limit (cubed), grouped by the first reason that applies to them.
  std::vector<ImproveObstacle> explain(double limit) const;

 private:
  enum class Force : std::uint8_t { none, edge, corner, triangle };
  struct Forced {
    double bound = 3;
    double angle = 0;  ///< degrees
    Force by = Force::none;
  };
  void read_edge(Dart e);
  void read_face(Dart f);
  bool is_crease(Dart e);
  bool is_thin_at(std::size_t rim) const;  ///< the face of the ring
  void force(Dart at, const Forced& f);
  std::string reason_of(Index t, double& bound) const;

  const Workspace& work_;
  SurfaceSplits splits_;
  std::vector<Forced> forced_;  ///< per vertex: the strongest thing at it
  double bound_ = 3;
  Vec3 place_{};
  Ring ring_;
  std::vector<std::size_t> held_faces_;
};

}  // namespace multimesh::improvement
