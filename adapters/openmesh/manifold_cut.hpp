// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <cstddef>

namespace multimesh::openmesh {

/// Cuts a user's mesh in place at vertices that join several fans of faces, so that it can be attached, and
/// joins it again:
///
///     openmesh::ManifoldCut cut(mesh);         \      /        \    a    /
///     {                                         \    /          \  / \  /
///       openmesh::Attached attached(mesh);     --- a ---   =>    \/   \/
///       ..                                      /    \           /\   /\    .
///     }                                        /      \         /  \ /  \   .
///     cut.join();                                               a' (same place)
///
/// One fan keeps the vertex; each other fan gets a copy of it, with all of its properties, of any type.
/// Faces, edges and halfedges keep their handles and properties. A property "multimesh:cut" stores which
/// vertices are one; it follows garbage collections and copies of the mesh. Until they are joined, copies are
/// locked (status bit), so that they stay at one place. Operations of an Attached that would make two edges
/// of one vertex coincide are refused ("copies can be joined").
///
/// A vertex can be joined again if all of its fans are open: in OpenMesh, a vertex with a closed fan has no
/// other one. Where two triangles, or two edges, would still have the same vertices, triangles are
/// disconnected from their neighbours and get edges of their own; those stay apart. Elements without faces
/// are left as they are.
class ManifoldCut {
 public:
  /// \throw UsageError if the mesh is attached. Cost: linear
  explicit ManifoldCut(OpenMesh::PolyConnectivity& mesh);
  /// Joins what can be joined, unless join() or keep() was called or the mesh is attached.
  ~ManifoldCut();
  ManifoldCut(const ManifoldCut&) = delete;
  ManifoldCut& operator=(const ManifoldCut&) = delete;

  /// The number of vertices that were added.
  std::size_t copies() const noexcept { return copies_; }

  struct Joined {
    std::size_t copies = 0;  ///< joined with another vertex again
    std::size_t left = 0;    ///< that stay apart: a fan is closed, or they have a common neighbour
  };
  /// Makes copies one vertex again, and unlocks them. The one with the lowest index stays, with its
  /// properties. Copies at the end of the mesh's vertices are removed; others are marked as deleted, as by
  /// OpenMesh's own operations, until the user's garbage_collection(). \throw UsageError if the mesh is
  /// attached. Cost: linear
  Joined join();
  /// Leaves the mesh cut permanently, and unlocks the copies. \throw UsageError if the mesh is attached
  void keep();

 private:
  OpenMesh::PolyConnectivity& mesh_;
  std::size_t copies_ = 0;
  bool is_cut_ = true;
};

}  // namespace multimesh::openmesh
