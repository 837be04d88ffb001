// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <cstddef>

#include "multimesh/openmesh/attached_tree.hpp"
#include "multimesh/openmesh/saved_star.hpp"

namespace multimesh::openmesh {

/// A module for OpenMesh's decimaters (DecimaterT, McDecimaterT, MixedDecimaterT) that makes them decimate
/// all meshes of a tree. It is binary, and can be combined with others of any kind:
///
///     openmesh::Attached attached(mesh);
///     OpenMesh::Decimater::DecimaterT<MyMesh> decimater(mesh);
///     openmesh::ModMultimeshT<MyMesh>::Handle tree;
///     decimater.add(tree);
///     decimater.module(tree).drive(attached);
///
/// It rejects what the tree would refuse: because of the legality of all its meshes, because the from-vertex
/// must keep its place, or because of the invariants of the operations. OpenMesh's halfedge collapse is
/// carried to all meshes.
///
/// When a decimater comes to an edge that it judged earlier, it checks the topology of its own mesh again,
/// but does not ask the modules again. If the tree refuses by then, the collapse is reverted, the tree stays
/// valid, and stale() counts it. The decimater counts one collapse too many, and a quadric was added to the
/// surviving vertex. To make up for it, call decimate() again.
template <class MeshT>
class ModMultimeshT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModMultimeshT, MeshT, Multimesh);

  explicit ModMultimeshT(MeshT& mesh) : Base(mesh, true), saved_(mesh) {}

  /// The tree whose root is the decimater's mesh; it must outlive the module.
  void drive(AttachedTree& tree) { tree_ = &tree; }

  /// \throw UsageError if drive() was not called
  void initialize() override {
    if (tree_ == nullptr) throw UsageError("ModMultimesh: call drive() with the tree of the mesh first");
    stale_ = 0;
  }
  float collapse_priority(const CollapseInfo& ci) override {
    return tree_->operations()
                   .why_not_collapse(NodeId::root, tree_->dart(ci.v0v1), Placement::keep_b())
                   .refused()
               ? float(Base::ILLEGAL_COLLAPSE)
               : float(Base::LEGAL_COLLAPSE);
  }
  void preprocess_collapse(const CollapseInfo& ci) override { saved_.save(ci.v0); }
  /// Reverts OpenMesh's collapse and does the tree's.
  void postprocess_collapse(const CollapseInfo& ci) override {
    saved_.restore();
    if (!tree_->collapse(ci.v0v1)) ++stale_;
  }

  /// How many collapses of the last run were reverted.
  std::size_t stale() const noexcept { return stale_; }

 private:
  AttachedTree* tree_ = nullptr;
  SavedStar saved_;
  std::size_t stale_ = 0;
};

}  // namespace multimesh::openmesh
