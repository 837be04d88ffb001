// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <atomic>
#include <memory>

namespace multimesh::openmesh {

/// Marks an OpenMesh mesh as attached.
///
/// OpenMesh copies all properties of a mesh, so a copy of an attached mesh has our properties, too, and keeps
/// them when its original is detached. The mark tells to which mesh they belong: those of a copy are removed
/// when the copy is attached itself.
class Attachment {
 public:
  /// \throw UsageError if the mesh is attached
  explicit Attachment(OpenMesh::PolyConnectivity& om);
  ~Attachment();
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;

  /// Whether the mesh was copied while its original was attached: it has the status that we requested there.
  bool of_copy() const noexcept { return of_copy_; }

  /// The attached mesh; nullptr once it is detached. Shared by the mark and its copies.
  using Owner = std::shared_ptr<std::atomic<const OpenMesh::PolyConnectivity*>>;

 private:
  OpenMesh::PolyConnectivity& om_;
  OpenMesh::MPropHandleT<Owner> mark_;
  bool of_copy_ = false;
};

bool is_attached(const OpenMesh::PolyConnectivity& om);
/// \throw UsageError if it is
void require_detached(const OpenMesh::PolyConnectivity& om);

}  // namespace multimesh::openmesh
