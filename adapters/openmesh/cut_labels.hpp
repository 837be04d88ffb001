// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/invariant.hpp"

namespace multimesh::openmesh {

/// A property of a mesh that a ManifoldCut has cut: per vertex, which vertices are copies of one. 0: a vertex
/// without copies; the lowest bit says whether the user had locked the vertex before.
using CutLabel = int;
constexpr const char* cut_label_name = "multimesh:cut";

/// The labels, or nullptr if the mesh is not cut. They live as long as the property.
const std::vector<CutLabel>* cut_labels(const OpenMesh::PolyConnectivity& mesh);

/// Refuses new edges of the root that would coincide with others once copies of a vertex are joined again, or
/// that join two vertices with copies. Cost: the stars of the neighbours that a vertex gains.
class CopiesCanBeJoined final : public Invariant {
 public:
  explicit CopiesCanBeJoined(const std::vector<CutLabel>& labels)
      : Invariant("copies can be joined", NodeId::root), labels_(labels) {}
  bool before(const Event& event) override;

 private:
  CutLabel label(const Mesh& mesh, Dart at) const { return labels_[mesh.vertex(at)]; }
  bool allows_split(const Mesh& mesh, Dart edge);
  bool allows_swap(const Mesh& mesh, Dart edge);
  bool allows_collapse(const Mesh& mesh, Dart edge);
  bool has_neighbour_like(const Mesh& mesh, Dart vertex, CutLabel label, Index but);

  const std::vector<CutLabel>& labels_;
  DartBuffer star_;
  DartBuffer kept_, gained_, around_;
};

}  // namespace multimesh::openmesh
