// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <concepts>

namespace multimesh::openmesh {

/// Recognizes an OpenMesh::PropertyManager by its interface: VProp<T>, .., or from getOrMakeProperty().
template <class M, class Handle>
concept ManagerOf = requires(const M& manager) {
  { manager.getRawProperty() } -> std::convertible_to<const Handle&>;
};

/// A vertex, edge, halfedge or face property of values of type M::Value, by its manager.
template <class M>
concept VertexPropertyManager = ManagerOf<M, OpenMesh::VPropHandleT<typename M::Value>>;
template <class M>
concept FacePropertyManager = ManagerOf<M, OpenMesh::FPropHandleT<typename M::Value>>;

}  // namespace multimesh::openmesh
