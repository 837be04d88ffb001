// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <cstddef>

namespace multimesh::openmesh {

/// Cuts a mesh of the user's in place at vertices that join several fans of faces, so that it can be
/// attached, and joins it again:
///
///     openmesh::ManifoldCut cut(mesh);         \      /        \    a    /
///     {                                         \    /          \  / \  /
///       openmesh::Attached attached(mesh);     --- a ---   =>    \/   \/
///       ..                                      /    \           /\   /\    .
///     }                                        /      \         /  \ /  \   .
///     cut.join();                                               a' (same place)
///
/// One fan keeps the vertex; each other one gets a copy of it, with all of its properties, of any type.
/// Faces, edges and halfedges keep their handles and properties. A property "multimesh:cut" says which
/// vertices are one; it follows garbage collections and copies of the mesh. Until they are joined, copies are
/// locked (status bit), so that they stay at one place, and operations of an Attached that would bring two
/// edges of one vertex upon each other are refused ("copies can be joined").
///
/// A vertex can be joined again if all of its fans are open: in OpenMesh, a vertex with a closed fan has no
/// other one. Where two triangles, or two edges, have the same vertices even so, triangles are taken out of
/// their neighbourhood, with edges of their own; those stay apart. Elements without faces are left as they
/// are.
class ManifoldCut {
 public:
  /// \throw UsageError if the mesh is attached. Cost: linear
  explicit ManifoldCut(OpenMesh::PolyConnectivity& mesh);
  /// Joins what can be joined, unless join() or keep() was called or the mesh is attached.
  ~ManifoldCut();
  ManifoldCut(const ManifoldCut&) = delete;
  ManifoldCut& operator=(const ManifoldCut&) = delete;

  /// How many vertices were added.
  std::size_t copies() const noexcept { return copies_; }

  struct Joined {
    std::size_t copies = 0;  ///< that are one vertex with another one again
    std::size_t left = 0;    ///< that stay apart: a fan is closed, or they have a neighbour in common
  };
  /// Makes copies one vertex again, and unlocks them. That of the lowest index stays, with its properties.
  /// Copies at the end of the mesh's vertices are removed; others, as by OpenMesh's own operations, are
  /// marked as deleted, until the user's garbage_collection(). \throw UsageError if the mesh is attached.
  /// Cost: linear
  Joined join();
  /// Leaves the mesh cut for good, and unlocks the copies. \throw UsageError if the mesh is attached
  void keep();

 private:
  OpenMesh::PolyConnectivity& mesh_;
  std::size_t copies_ = 0;
  bool is_cut_ = true;
};

}  // namespace multimesh::openmesh
