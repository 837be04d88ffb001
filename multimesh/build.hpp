// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/cut.hpp"
#include "multimesh/multi_mesh.hpp"

namespace multimesh {

/// Makes a mesh from a manifold facet list: facet i gets index i, vertex j index j. An adapter supplies one
/// (multimesh::openmesh::make_mesh), so the core depends on no adapter.
using MeshFactory = std::function<std::unique_ptr<Mesh>(const FacetList&)>;

/// Adds a child of the parent's dimension or lower, facet by facet. Child facet i lies over the simplex of
/// the parent with the vertices parent.facet(i), in corresponding order (OBJ v/vt pairs; a periodic tile over
/// its torus). `parent_facets`: per child facet, a parent facet that contains that simplex. Lists that are
/// moved in are freed before the map is stored, which lowers the peak memory of a large mesh by two lists.
/// \throw InputError naming a facet whose vertices do not correspond; the tree is unchanged then
NodeId add_child_by_facets(MultiMesh& tree, NodeId parent, FacetList child, FacetList over,
                           std::span<const Index> parent_facets, const MeshFactory& make);

/// Adds the tagged k-simplices of a mesh as a child, 0 <= k <= its dimension, cut to be manifold. `tagged` is
/// called once per live k-simplex index. \throw InputError if none is tagged, or a tagged vertex is in no
/// facet
NodeId add_child_from_tags(MultiMesh& tree, NodeId parent, int k, const std::function<bool(Index)>& tagged,
                           const MeshFactory& make, const CutOptions& options = {});

/// Adds the boundary of a mesh of dimension 1 or more as a child; for curves, their ends. \throw InputError
/// if the mesh is closed
NodeId add_child_from_boundary(MultiMesh& tree, NodeId parent, const MeshFactory& make,
                               const CutOptions& options = {});

}  // namespace multimesh
