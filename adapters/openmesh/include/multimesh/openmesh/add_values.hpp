// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <string>

namespace multimesh::openmesh {

/// Returns the list of a new property of an OpenMesh mesh. The mesh owns it; it grows and is compacted with
/// the mesh. `handle`: an OpenMesh::VPropHandleT<T>, EPropHandleT<T>, ..
template <class Handle>
auto& add_values(OpenMesh::PolyConnectivity& om, Handle handle, const std::string& name) {
  om.add_property(handle, name);
  return om.property(handle).data_vector();
}

}  // namespace multimesh::openmesh
