// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/coordinates.hpp"

namespace multimesh {

CoordinatesFromParent::CoordinatesFromParent(const MultiMesh& tree, NodeId n, Coordinates& above)
    : tree_(tree),
      node_(n),
      above_(above),
      values_(tree.mesh(n).capacity(0), Vec3(0, 0, 0)),
      attribute_(n, values_, [this](Operation, const VertexChange& c) { return above_.at(c.above); }) {
  const Mesh& mesh = tree.mesh(n);
  const Mesh& parent = tree.mesh(tree.parent(n));
  for (Index v = 0; v < values_.size(); ++v)
    if (mesh.is_live(0, v) && mesh.dart_of(0, v) != no_dart)
      values_[v] = above.at(parent.vertex(tree.to_parent(n, mesh.dart_of(0, v))));
}

void CoordinatesFromParent::set(Index v, const Vec3& x) {
  above_.set(above(v), x);
}

Vec3 CoordinatesFromParent::place_of_copy(Index copy, Index v, const Vec3& x) const {
  return copy == v ? x : above_.place_of_copy(above(copy), above(v), x);
}

Index CoordinatesFromParent::above(Index v) const {
  return tree_.mesh(tree_.parent(node_)).vertex(tree_.to_parent(node_, tree_.mesh(node_).dart_of(0, v)));
}

}  // namespace multimesh
