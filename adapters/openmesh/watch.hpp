// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "multimesh/mesh.hpp"

namespace multimesh::openmesh {

/// Tells whether a connectivity that others can reach is still as our last write left it.
///
/// OpenMesh has no hooks, so the only sure signs are the words themselves. Per vertex we keep the sum, over
/// its outgoing halfedges, of a hash of (halfedge, its end, its face). Each write of ours moves the sums
/// along, and undoing it moves them back; a sum that a walk around the vertex does not give again was changed
/// by somebody else. Elements have names of their own, too, so that a renumbering (garbage collection) can be
/// told from other changes and followed. Properties "mm:watch*": 8 bytes per vertex and 4 per element.
class Watch {
 public:
  /// Takes the connectivity as it is. Cost: linear
  explicit Watch(OpenMesh::PolyConnectivity& om);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Around each write of ours: leave out the halfedges that it changes, and put them in again. Those of dead
  // edges, and without a vertex, do not count.
  void leave_out(int halfedge) { count(halfedge, false); }
  void put_in(int halfedge) { count(halfedge, true); }
  /// New elements have been added, or the last ones taken away: they are ours.
  void note_counts();
  void name(int k, int element);

  bool same_counts() const noexcept;
  /// Whether the halfedges out of a vertex are those that we left. Cost: that of a walk around it
  bool in_step(int vertex) const;
  /// Everywhere; the first vertex that is out of step, dead ones included, or nothing. Cost: linear
  std::optional<int> first_out_of_step() const;

  /// Where the elements that had names have gone, by their old indices. \throw OutOfStepError if names are
  /// missing or found twice: the mesh was cleared or assigned
  Compaction moved() const;
  /// Whether the mesh is what it was but for the new indices: every vertex that is left has the halfedges
  /// that it had, by their old names. Else the first vertex that has not.
  std::optional<int> first_changed(const Compaction& moved) const;
  /// Takes the connectivity as it is now.
  void accept();

  /// Whether a property belongs to a watch.
  static bool owns(const OpenMesh::BaseProperty& property);

 private:
  using Counts = std::array<std::size_t, 3>;
  Counts counts_now() const;
  bool is_dead(int k, int element) const;
  void count(int halfedge, bool in);
  template <class Name>
  std::uint64_t sum_around(int vertex, const Name& name) const;

  OpenMesh::PolyConnectivity& om_;
  Counts counts_{};
  OpenMesh::VPropHandleT<std::uint64_t> sum_property_;
  OpenMesh::VPropHandleT<Index> vertex_names_;
  OpenMesh::EPropHandleT<Index> edge_names_;
  OpenMesh::FPropHandleT<Index> face_names_;
  std::vector<std::uint64_t>* sums_;
  std::array<std::vector<Index>*, 3> names_;  // one more than the index that we know; 0: not ours
};

}  // namespace multimesh::openmesh
