// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/openmesh/corner_values.hpp"

#include <array>

#include "multimesh/openmesh/triangle_mesh.hpp"

namespace multimesh::openmesh {

// The dart (v0,v1,v2) of a triangle at its halfedge v0->v1 or, flipped, v1->v0.
void corners_below(const MultiMesh& tree, NodeId child, Dart d, std::vector<Corner>& out) {
  const auto& parent = dynamic_cast<const TriangleMesh&>(tree.mesh(tree.parent(child)));
  const Dart above = tree.to_parent(child, d);
  const auto h = TriangleMesh::halfedge(above);
  const int ahead = parent.openmesh().next_halfedge_handle(h).idx();
  const int behind = parent.openmesh().prev_halfedge_handle(h).idx();
  const bool flipped =
      static_cast<Index>(parent.openmesh().to_vertex_handle(h).idx()) == parent.vertex(above);
  std::array<Index, 4> v{};
  tree.mesh(child).vertices(d, v.data());
  out.push_back({static_cast<std::size_t>(flipped ? h.idx() : behind), v[0]});
  out.push_back({static_cast<std::size_t>(flipped ? behind : h.idx()), v[1]});
  out.push_back({static_cast<std::size_t>(ahead), v[2]});
}

void corners_changed(const Event& event, NodeId child, std::vector<Corner>& out) {
  const Mesh& mesh = event.tree.mesh(child);
  DartBuffer star;
  for (const Copy& c : event.copies.of(child)) {
    // After a split the dart is (a,c,..): the new vertex is the second one.
    const Dart at = event.operation == Operation::split ? mesh.reorder(c.dart, exchange_ends) : c.dart;
    mesh.star(at, event.operation == Operation::flip ? 1 : 0, star);
    for (const Dart t : star) corners_below(event.tree, child, t, out);
  }
}

void all_corners(const MultiMesh& tree, NodeId child, std::vector<Corner>& out) {
  const Mesh& mesh = tree.mesh(child);
  for (Index f = 0; f < mesh.capacity(2); ++f)
    if (mesh.is_live(2, f)) corners_below(tree, child, mesh.dart_of(2, f), out);
}

}  // namespace multimesh::openmesh
