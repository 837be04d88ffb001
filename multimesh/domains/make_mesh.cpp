// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/make_mesh.hpp"

#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh {

std::unique_ptr<Mesh> make_mesh(const FacetList& facets) {
  if (facets.dimension == 3) return std::make_unique<tet::TetMesh>(facets);
  return openmesh::make_mesh(facets);
}

}  // namespace multimesh
