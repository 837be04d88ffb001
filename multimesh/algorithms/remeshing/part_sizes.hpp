// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "multimesh/embedding.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::remeshing {

/// The areas of the parts of a plane surface (Embedding::tell_parts). A curve between two parts that is
/// remeshed runs along chords of the curve that it was, and takes area from one of them.
class PartSizes {
 public:
  /// Remembers the areas. Cost: linear
  explicit PartSizes(const EmbeddedMesh& surface);

  /// False if there are no parts, if the surface is not plane, or if it has charts: then there is nothing to
  /// restore.
  bool are_known() const noexcept { return !before_.empty(); }

  /// A vertex of a curve, and where the next ones along it are.
  struct CurveVertex {
    Dart vertex;
    Vec3 before, after;
  };
  struct Step {
    Dart vertex;
    Vec3 by;
  };
  /// The least steps after which, to first order, the parts have the areas that they had, or as nearly as may
  /// be. Each is weighted by how much the curve bends there: what is straight stays straight. Cost: linear in
  /// the vertices for each step of the solver
  std::vector<Step> steps(const std::vector<CurveVertex>& vertices) const;

  /// How far the areas are from what they were, relative to each; the largest.
  double largest_change() const;

 private:
  using Part = std::int32_t;
  std::map<Part, double> areas() const;
  Part part(Dart triangle) const { return (*parts_)[mesh_.facet(triangle)]; }
  /// How the area of each part grows with a step along the plane.
  std::map<Part, Vec3> gradients(Dart vertex) const;

  const Mesh& mesh_;
  const Coordinates& positions_;
  const std::vector<Part>* parts_ = nullptr;
  Vec3 normal_;
  std::map<Part, double> before_;
  mutable DartBuffer star_;
};

}  // namespace multimesh::remeshing
