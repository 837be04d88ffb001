// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/attachment.hpp"

#include "multimesh/error.hpp"

namespace multimesh::openmesh {

namespace {

constexpr const char* mark_name = "mm:attached";

/// Removes the properties of one kind of element that are ours. Handles are plain indices.
template <class Handle, class Iterator>
void remove_ours(OpenMesh::PolyConnectivity& om, Iterator begin, Iterator end) {
  int i = 0;
  for (auto p = begin; p != end; ++p, ++i) {
    if (!*p || (*p)->name().rfind("mm:", 0) != 0) continue;
    Handle handle(i);
    om.remove_property(handle);
  }
}

void remove_ours(OpenMesh::PolyConnectivity& om) {
  remove_ours<OpenMesh::VPropHandleT<char>>(om, om.vprops_begin(), om.vprops_end());
  remove_ours<OpenMesh::HPropHandleT<char>>(om, om.hprops_begin(), om.hprops_end());
  remove_ours<OpenMesh::EPropHandleT<char>>(om, om.eprops_begin(), om.eprops_end());
  remove_ours<OpenMesh::FPropHandleT<char>>(om, om.fprops_begin(), om.fprops_end());
  remove_ours<OpenMesh::MPropHandleT<char>>(om, om.mprops_begin(), om.mprops_end());
}

}  // namespace

bool is_attached(const OpenMesh::PolyConnectivity& om) {
  OpenMesh::MPropHandleT<Attachment::Owner> mark;
  return om.get_property_handle(mark, mark_name) && om.property(mark)->load() == &om;
}

void require_detached(const OpenMesh::PolyConnectivity& om) {
  if (is_attached(om)) throw UsageError("this OpenMesh mesh is already part of a multimesh; detach it first");
}

Attachment::Attachment(OpenMesh::PolyConnectivity& om) : om_(om) {
  require_detached(om);
  if (om.get_property_handle(mark_, mark_name)) {
    remove_ours(om);
    of_copy_ = true;
  }
  om.add_property(mark_, mark_name);
  om.property(mark_) = std::make_shared<Owner::element_type>(&om);
}

Attachment::~Attachment() {
  om_.property(mark_)->store(nullptr);
  om_.remove_property(mark_);
}

}  // namespace multimesh::openmesh
