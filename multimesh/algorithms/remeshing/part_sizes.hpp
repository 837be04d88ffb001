// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "multimesh/embedding.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::remeshing {

/// The areas of the parts of a plane surface, or the volumes of those of the tetrahedra in which a surface is
/// embedded (Embedding::tell_parts). Remeshed curves and surfaces between parts run along chords of what they
/// were, and take size from one of the parts.
class PartSizes {
 public:
  /// Remembers the sizes. Cost: linear
  explicit PartSizes(const EmbeddedMesh& surface);

  /// False if there are no parts, if the surface is neither plane nor in tetrahedra, or if it has charts:
  /// then there is nothing to restore.
  bool are_known() const noexcept { return !before_.empty(); }
  bool are_areas() const noexcept { return node_ == surface_; }
  /// Of a plane surface.
  const Vec3& normal() const noexcept { return normal_; }
  /// How far the sizes are from what they were, relative to each; the largest. Cost: linear
  double largest_change() const;

  /// A vertex of the surface, and a direction in which it may leave its place.
  struct Step {
    Dart vertex;
    Vec3 by;
  };
  /// Makes each as long as is needed: the least multiples, as a sum of squares, after which the parts have to
  /// first order the sizes that they had, or come as near to them as they may. Cost: the stars, and for each
  /// step of the solver linear in them
  void scale(std::vector<Step>& steps) const;

 private:
  using Part = std::int32_t;
  std::map<Part, double> sizes() const;
  /// How the size of each part grows with a step of the vertex.
  std::map<Part, Vec3> gradients(Dart vertex) const;

  const MultiMesh& tree_;
  NodeId surface_, node_;  // the latter: of the parts
  const Mesh* mesh_ = nullptr;
  const Coordinates* positions_ = nullptr;
  const std::vector<Part>* parts_ = nullptr;
  Vec3 normal_{0, 0, 0};
  std::map<Part, double> before_;
  mutable DartBuffer star_;
};

}  // namespace multimesh::remeshing
