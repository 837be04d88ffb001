// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "multimesh/cut.hpp"
#include "multimesh/mesh.hpp"

namespace multimesh {

/// Makes a mesh from a facet list of dimension 0 to 3: points, edges and triangles over OpenMesh
/// connectivity, tetrahedra in a tet::TetMesh. A MeshFactory for the functions of multimesh/build.hpp.
/// \pre manifold and a proper simplicial complex, as made by multimesh::cut. \throw InputError naming a
/// facet that does not fit
std::unique_ptr<Mesh> make_mesh(const FacetList& facets);

}  // namespace multimesh
