// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "multimesh/error.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/operations.hpp"

namespace multimesh::openmesh {

/// The root's connectivity, for algorithms that keep values of their own on its elements while they run.
/// \throw UsageError in the algorithm's name if the root is no surface over OpenMesh
inline OpenMesh::PolyConnectivity& root_surface(Propagation& operations, const std::string& algorithm) {
  auto& root = const_cast<Mesh&>(operations.tree().mesh(NodeId::root));
  auto* connectivity = dynamic_cast<Connectivity*>(&root);
  if (connectivity == nullptr || root.dimension() != 2)
    throw UsageError(algorithm + ": the root must be a surface over OpenMesh");
  return connectivity->openmesh();
}

}  // namespace multimesh::openmesh
