// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/embedding.hpp"
#include "multimesh/openmesh/attach.hpp"

namespace multimesh {

/// A user's own OpenMesh mesh with everything attached to it, for algorithms: its points, the texture
/// coordinates if there are any, and the attributes and invariants of its operations. Children and properties
/// that are added later are not included. Must not outlive `attached`. Cost: constant
template <class UserMesh>
Embedding embedding(openmesh::Attached<UserMesh>& attached) {
  Embedding e(attached.operations());
  e.add_coordinates(attached.points(), Embedding::Kind::space);
  if (attached.has_texture()) e.add_coordinates(attached.texcoords(), Embedding::Kind::chart);
  return e;
}

}  // namespace multimesh
