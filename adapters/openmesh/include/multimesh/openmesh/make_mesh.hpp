// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "multimesh/cut.hpp"
#include "multimesh/mesh.hpp"

namespace multimesh::openmesh {

/// Makes a mesh of points, edges or triangles over an OpenMesh connectivity of its own; facet i has index i,
/// vertex j index j. \pre manifold and a proper simplicial complex, as made by multimesh::cut.
/// \throw InputError naming a facet that does not fit
std::unique_ptr<Mesh> make_mesh(const FacetList& facets);

}  // namespace multimesh::openmesh
