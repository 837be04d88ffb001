// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/coordinates.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh {

/// Refuses operations after which a facet around the vertex or edge, of the mesh whose coordinates these are,
/// has negative or no volume, by exact signs; wherever in the tree the operation is asked for. Triangles: no
/// area, as seen against `normal`. Facets that are inverted before must be kept from it by their owner.
/// Collapses are judged before they are done. Cost: the star of the vertex, per preimage.
class KeepsOrientation final : public Invariant {
 public:
  explicit KeepsOrientation(const Coordinates& positions, const Vec3& normal = {0, 0, 1});
  bool before(const Event& event) override;
  bool after(const Event& event) override;

 private:
  bool is_positive(const Mesh& mesh, Dart facet, Index replaced, const Vec3& by) const;

  const Coordinates& positions_;
  Vec3 normal_;
  DartBuffer star_;
};

}  // namespace multimesh
