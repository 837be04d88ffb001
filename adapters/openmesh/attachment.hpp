// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <atomic>
#include <memory>

namespace multimesh::openmesh {

/// Marks an OpenMesh mesh as attached.
///
/// OpenMesh copies all properties of a mesh, so a copy of an attached mesh has our properties, too, and keeps
/// them when its original is detached. The mark says whose it is: those of a copy are removed when the copy
/// is attached itself.
class Attachment {
 public:
  /// \throw UsageError if the mesh is attached
  explicit Attachment(OpenMesh::PolyConnectivity& om);
  ~Attachment();
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;

  /// Whether the mesh was copied while its original was attached: it has the status that we requested there.
  bool of_copy() const noexcept { return of_copy_; }

 private:
  // The attached mesh; nullptr once it is detached. Shared by the mark and its copies.
  using Owner = std::shared_ptr<std::atomic<const OpenMesh::PolyConnectivity*>>;

  OpenMesh::PolyConnectivity& om_;
  OpenMesh::MPropHandleT<Owner> mark_;
  bool of_copy_ = false;
};

}  // namespace multimesh::openmesh
