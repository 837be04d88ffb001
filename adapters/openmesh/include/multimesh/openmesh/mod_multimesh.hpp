// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Tools/Decimater/ModBaseT.hh>
#include <cstddef>

#include "multimesh/openmesh/attached_tree.hpp"
#include "multimesh/openmesh/saved_star.hpp"

namespace multimesh::openmesh {

/// A module for OpenMesh's decimaters (DecimaterT, McDecimaterT, MixedDecimaterT), by which they decimate all
/// meshes of a tree. It is binary, for use beside others of any kind:
///
///     openmesh::Attached attached(mesh);
///     OpenMesh::Decimater::DecimaterT<MyMesh> decimater(mesh);
///     openmesh::ModMultimeshT<MyMesh>::Handle tree;
///     decimater.add(tree);
///     decimater.module(tree).drive(attached);
///
/// It forbids what the tree would refuse: by the legality of all its meshes, because the from-vertex must
/// keep its place, or by the invariants of the operations. OpenMesh's half-edge collapse is carried to all
/// meshes.
///
/// A decimater asks again for the topology of its own mesh, but not for the other modules' opinions, when it
/// comes to an edge that it judged earlier. If the tree refuses by then, the collapse is taken back, the tree
/// stays valid, and stale() counts it: the decimater believes in one collapse more than there were, and a
/// quadric was added to the surviving vertex. To make up for it, call decimate() again.
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
  /// Takes OpenMesh's collapse back and does the tree's.
  void postprocess_collapse(const CollapseInfo& ci) override {
    saved_.restore();
    if (!tree_->collapse(ci.v0v1)) ++stale_;
  }

  /// How many collapses of the last run were taken back.
  std::size_t stale() const noexcept { return stale_; }

 private:
  AttachedTree* tree_ = nullptr;
  SavedStar saved_;
  std::size_t stale_ = 0;
};

}  // namespace multimesh::openmesh
