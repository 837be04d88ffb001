// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/openmesh/connectivity.hpp"

namespace multimesh::openmesh {

/// Curves over OpenMesh connectivity without faces: open chains and closed loops of edges. The halfedges of
/// a component are linked along the polyline, forward and back, and turn round at the ends of a chain; a
/// closed loop has two cycles. A dart is a halfedge, with its from-vertex.
class EdgeMesh final : public Connectivity {
 public:
  /// \throw InputError naming the first vertex with more than two edges, halfedge that is linked
  /// differently, or pair of edges with the same vertices; UsageError if the mesh is already attached
  explicit EdgeMesh(OpenMesh::PolyConnectivity& om, Watching edits = Watching::on);
  /// Takes ownership of a mesh. \throw as the other constructor, but does not check for simplices with the
  /// same vertices
  explicit EdgeMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om);

  static OpenMesh::HalfedgeHandle halfedge(Dart d) { return handle(half(d)); }
  static Dart dart(OpenMesh::HalfedgeHandle h) { return make(h.idx()); }

  Index capacity(int k) const override;
  bool is_live(int k, Index s) const override;
  bool is_dart(Dart d) const override;
  Index simplex(Dart d, int k) const override;
  Dart dart_of(int k, Index s) const override;
  Dart switch_dart(Dart d, int k) const override;
  Dart reorder(Dart d, Permutation p) const override { return make(half(d) ^ static_cast<int>(p.code)); }
  Permutation order(Dart from, Dart to) const override {
    return {static_cast<std::uint8_t>((code(from) ^ code(to)) & 1U)};
  }
  void vertices(Dart d, Index* out) const override;
  /// A corner is the halfedge that points to the vertex.
  Index corner(Dart d) const override { return static_cast<Index>(half(d) ^ 1); }
  Index corner_capacity() const override { return static_cast<Index>(om_.n_halfedges()); }
  void star(Dart d, int k, DartBuffer& out) const override;
  bool is_boundary(Dart d, int k) const override;
  bool link_condition(Dart e) const override;
  void split_edge(Dart e, SplitRecord& record) override;
  void collapse_edge(Dart e, CollapseRecord& record) override;
  void collapse_region(Dart e, CollapseRegion& region) const override;
  Dart after_split(const SplitRecord& record, Dart old, End end) const override;
  Dart after_collapse(const CollapseRecord& record, Dart old) const override;
  void check(std::vector<std::string>& problems) const override;

 private:
  static int half(Dart d) { return static_cast<int>(code(d)); }
  static Dart make(int h) { return Dart{static_cast<std::uint32_t>(h)}; }
};

}  // namespace multimesh::openmesh
