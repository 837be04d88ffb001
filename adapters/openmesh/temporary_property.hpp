// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

namespace multimesh::openmesh {

/// A property of a mesh that goes when this does. `Handle`: an OpenMesh::VPropHandleT<T>, EPropHandleT<T>, ..
template <class Handle>
class TemporaryProperty {
 public:
  TemporaryProperty(OpenMesh::PolyConnectivity& om, const char* name) : om_(om) {
    om_.add_property(handle_, name);
  }
  ~TemporaryProperty() { om_.remove_property(handle_); }
  TemporaryProperty(const TemporaryProperty&) = delete;
  TemporaryProperty& operator=(const TemporaryProperty&) = delete;
  auto& values() { return om_.property(handle_).data_vector(); }

 private:
  OpenMesh::PolyConnectivity& om_;
  Handle handle_;
};

}  // namespace multimesh::openmesh
