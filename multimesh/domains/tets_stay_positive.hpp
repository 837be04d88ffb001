// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/coordinates.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// Refuses operations after which a tetrahedron around the vertex or edge has negative or no volume, by exact
/// signs, in the mesh to which the coordinates belong. Collapses are judged before they are done. Cost: the
/// star of the vertex, per copy.
class TetsStayPositive final : public Invariant {
 public:
  explicit TetsStayPositive(const Coordinates& positions);
  bool before(const Event& event) override;
  bool after(const Event& event) override;

 private:
  bool is_positive(const Mesh& mesh, Dart tet, Index replaced, const Vec3& by) const;

  const Coordinates& positions_;
  DartBuffer star_;
};

}  // namespace multimesh
