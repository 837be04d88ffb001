// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/openmesh/add_values.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh {

/// A column on the vertices of a mesh made by make_mesh, which owns it; it grows and is compacted with it.
template <class T>
std::vector<T>& add_vertex_values(Mesh& mesh, const std::string& name) {
  if (auto* tets = dynamic_cast<tet::TetMesh*>(&mesh)) return tets->add_vertex_property<T>(name).values;
  auto& om = dynamic_cast<openmesh::Connectivity&>(mesh).openmesh();
  return openmesh::add_values(om, OpenMesh::VPropHandleT<T>(), name);
}

/// The same on its facets; the halves of a split facet have the value of the whole.
template <class T>
std::vector<T>& add_facet_values(Mesh& mesh, const std::string& name) {
  if (auto* tets = dynamic_cast<tet::TetMesh*>(&mesh)) return tets->add_tet_property<T>(name).values;
  auto& om = dynamic_cast<openmesh::Connectivity&>(mesh).openmesh();
  return openmesh::add_values(om, OpenMesh::FPropHandleT<T>(), name);
}

/// The vertices of a facet in the order that gives its orientation, dimension + 1 of them.
inline void oriented_corners(const Mesh& mesh, Index facet, Index* out) {
  if (const auto* tets = dynamic_cast<const tet::TetMesh*>(&mesh)) {
    const Index* corners = tets->corners(facet);
    std::copy(corners, corners + 4, out);
  } else {
    mesh.vertices(mesh.dart_of(mesh.dimension(), facet), out);
  }
}

}  // namespace multimesh
