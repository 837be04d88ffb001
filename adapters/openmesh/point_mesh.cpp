// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/point_mesh.hpp"

#include <string>

#include "multimesh/error.hpp"

namespace multimesh::openmesh {

PointMesh::PointMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om) : Connectivity(0, *om) {
  require_consistent();
  own(std::move(om));
}

void PointMesh::refuse() {
  throw UsageError("a mesh of dimension 0 has no edges");
}

void PointMesh::check(std::vector<std::string>& problems) const {
  if (om_.n_edges() > 0 || om_.n_faces() > 0) problems.push_back("a mesh of points has edges or faces");
  for (Index v = 0; v < capacity(0); ++v)
    if (is_live(0, v) && out(static_cast<int>(v)) >= 0)
      problems.push_back("vertex " + std::to_string(v) + ": has an outgoing halfedge, but no edge");
}

}  // namespace multimesh::openmesh
