// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/openmesh/connectivity.hpp"

namespace multimesh::openmesh {

/// A triangle mesh over OpenMesh connectivity; all faces must be triangles, all vertices manifold.
///
/// A dart is 2*halfedge + flip: flip 0 has the halfedge's from-vertex, flip 1 its to-vertex; the facet is
/// the halfedge's face. Boundary halfedges carry no dart. (v0,v1,v2) is: vertex, other end, apex.
class TriangleMesh final : public Connectivity {
 public:
  /// Attaches a user's mesh in place. \throw InputError naming the first face that is not a triangle,
  /// vertex that is not manifold, or pair of simplices with the same vertices; UsageError if it is already
  /// attached
  explicit TriangleMesh(OpenMesh::PolyConnectivity& om, Watching edits = Watching::on);
  /// Takes ownership of a mesh. \throw as the other constructor, but does not check for simplices with the
  /// same vertices
  explicit TriangleMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om);
  /// Takes ownership of a mesh. \pre check() would find nothing
  struct Checked {};
  TriangleMesh(std::unique_ptr<OpenMesh::PolyConnectivity> om, Checked);

  static OpenMesh::HalfedgeHandle halfedge(Dart d) { return handle(half(d)); }
  /// The dart at the from-vertex of a halfedge that has a face.
  static Dart dart(OpenMesh::HalfedgeHandle h) { return make(h.idx(), 0); }
  /// The dart (a,b,..) of an edge, from either side; no_dart if the edge has no face.
  Dart edge_dart(OpenMesh::HalfedgeHandle a_to_b) const;

  Index capacity(int k) const override;
  bool is_live(int k, Index s) const override;
  bool is_dart(Dart d) const override;
  Index simplex(Dart d, int k) const override;
  Dart dart_of(int k, Index s) const override;
  Dart switch_dart(Dart d, int k) const override;
  Dart reorder(Dart d, Permutation p) const override;
  Permutation order(Dart from, Dart to) const override;
  void vertices(Dart d, Index* out) const override;
  /// A corner is the halfedge of the face that points to the vertex.
  Index corner(Dart d) const override {
    const int h = half(d);
    return static_cast<Index>(flip(d) ? h : prev(h));
  }
  Index corner_capacity() const override { return static_cast<Index>(om_.n_halfedges()); }
  void star(Dart d, int k, DartBuffer& out) const override;
  bool is_boundary(Dart d, int k) const override;
  bool has_link_around(LinkSet links, int j, Dart d, int k) const override;
  bool link_condition(Dart e) const override;
  void split_edge(Dart e, SplitRecord& record) override;
  void merge_values(Dart e, const Merging& merging) override;
  void collapse_edge(Dart e, CollapseRecord& record) override;
  void collapse_region(Dart e, CollapseRegion& region) const override;
  Dart after_split(const SplitRecord& record, Dart old, End end) const override;
  Dart after_collapse(const CollapseRecord& record, Dart old) const override;
  bool can_flip(Dart e) const override;
  void flip_edge(Dart e) override;
  void check(std::vector<std::string>& problems) const override;

 private:
  static int half(Dart d) { return static_cast<int>(code(d) >> 1); }
  static unsigned flip(Dart d) { return code(d) & 1U; }
  static Dart make(int h, unsigned flip) { return Dart{(static_cast<std::uint32_t>(h) << 1) | flip}; }
  /// The halfedge a->b of an edge dart (a,b,..).
  static int forward(Dart e) { return half(e) ^ static_cast<int>(flip(e)); }

  void require_triangles() const;
  bool boundary_vertex(int v) const { return out(v) < 0 || face(out(v)) < 0; }
  Dart dart_at(int v) const;
  bool common_neighbours_span_facets(int h) const;
  int find_halfedge(int from, int to) const;
  void merge_sides(int kept, int dying, int x, Carried carried, const Merging& merging);
  void close_loop(int kept, int dying);
  int outgoing_after_collapse(int h) const;
};

}  // namespace multimesh::openmesh
