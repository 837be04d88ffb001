// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/embedding.hpp"

#include <string>

namespace multimesh {

Coordinates* Embedding::find(NodeId n, Kind kind) const {
  for (const Known& k : coordinates_)
    if (k.kind == kind && k.coordinates->node() == n) return k.coordinates.get();
  return nullptr;
}

std::vector<Attribute*> EmbeddedMesh::inherited() const {
  std::vector<Attribute*> all;
  for (const auto& c : inherited_) all.push_back(&c->attribute());
  return all;
}

bool Embedding::is_only_seam(NodeId curves, Index edge) const {
  for (const auto& [node, is_only_seam] : seams_)
    if (node == curves) return is_only_seam(edge);
  return false;
}

EmbeddedMesh::EmbeddedMesh(const Embedding& embedding, NodeId n, bool judges_orientation)
    : embedding_(embedding), node_(n), operations_(embedding.operations_), mesh_(tree().mesh(n)) {
  std::vector<NodeId> way;  // from n up to what has coordinates
  for (NodeId above = n; !(positions_ = embedding.find(above, Embedding::Kind::space));
       above = tree().parent(above)) {
    if (above == NodeId::root)
      throw UsageError("embedding: neither mesh " + std::to_string(index(n)) +
                       " nor one above it has coordinates in space");
    way.push_back(above);
  }
  for (; !way.empty(); way.pop_back()) {
    inherited_.push_back(std::make_unique<CoordinatesFromParent>(tree(), way.back(), *positions_));
    operations_.add(inherited_.back()->attribute());
    positions_ = inherited_.back().get();
  }
  for (const auto& invariant : embedding.orientations_)
    if (!judges_orientation || invariant->node() != n) operations_.add(*invariant);
  for (const NodeId below : tree().descendants(n))
    if (Coordinates* chart = embedding.find(below, Embedding::Kind::chart);
        chart && tree().mesh(below).dimension() == mesh_.dimension())
      charts_.push_back(chart);
}

}  // namespace multimesh
