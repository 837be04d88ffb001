// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "multimesh/algorithms/decimation/collapse_plan.hpp"
#include "multimesh/embedding.hpp"

namespace multimesh::decimation {

/// As long as it lives and is not stopped, merged vertices go where a plan says, in space and in each chart.
class PlannedPlaces {
 public:
  /// All must outlive it.
  PlannedPlaces(const EmbeddedMesh& surface, const CollapsePlan& plan);

  /// For other code that collapses edges.
  void stop() { prescribed_.clear(); }
  void start();

  /// Makes the places of a plan those that the values can hold: some have fewer digits.
  void round(CollapsePlan& plan) const;

 private:
  std::optional<Vec3> position(const VertexChange& c) const;
  std::optional<Vec3> texcoord(std::size_t set, const VertexChange& c) const;

  const EmbeddedMesh& surface_;
  const CollapsePlan& plan_;
  std::vector<std::unique_ptr<PrescribedPlaces>> prescribed_;
};

}  // namespace multimesh::decimation
