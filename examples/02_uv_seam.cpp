// SPDX-License-Identifier: BSD-3-Clause
// What a UV seam is: an edge of the surface that is two edges of the texture. A collapse along it happens on
// both sides. A collapse that would pinch a chart, or move the seam, is refused with the reason.
#include <iostream>
#include <string>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/files/surface_file.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;

bool expect(bool fact, const std::string& what) {
  if (!fact) std::cerr << "wrong: " << what << '\n';
  return fact;
}

int main(int argc, char** argv) try {
  if (argc != 2) return std::cerr << "usage: 02_uv_seam MODEL.obj\n", 2;
  files::SurfaceFile file = files::read_surface(argv[1]);
  TexturedSurface surface = files::take_surface(file);
  MultiMesh& tree = surface.tree();
  const NodeId texture = surface.texture().value(), seams = surface.seams().value();
  const Mesh& root = tree.mesh(NodeId::root);
  const Mesh& curves = tree.mesh(seams);
  const MeshReport before = report(root), charts = report(tree.mesh(texture));

  // An edge in the middle of a seam, in each mesh.
  Dart on_seam = no_dart;
  for (Index e = 0; e < curves.capacity(1); ++e) {
    const Dart d = curves.dart_of(1, e);
    if (!curves.is_boundary(d, 0) && !curves.is_boundary(curves.switch_dart(d, 0), 0)) on_seam = d;
  }
  const Dart edge = tree.to_root(seams, on_seam);
  DartBuffer sides, across, same_side;
  tree.to_child(texture, edge, 1, sides);
  bool ok = expect(sides.size() == 2, "a seam edge has two preimages in the texture");
  tree.map(texture, sides[0], 1, texture, MultiMesh::Via::root, across);
  tree.map(texture, sides[0], 1, texture, MultiMesh::Via::lowest_common_ancestor, same_side);
  ok &= expect(across.size() == 2 && same_side.size() == 1, "the way through the root crosses the seam");

  // Collapsed along the seam: one edge less in the surface and in the curve, two in the texture's boundary.
  VertexAttribute position(NodeId::root, surface.positions());
  VertexAttribute texcoord(texture, surface.texcoords());
  Propagation propagation(tree);
  propagation.add(position).add(texcoord);
  const std::size_t seam_edges = report(curves).edges;
  const Outcome along = propagation.collapse(seams, on_seam, Placement::at(0.5));
  ok &= expect(bool(along), "collapse along a seam: " + std::string(to_string(along.refusal.check)));
  const MeshReport after = report(root), charts_after = report(tree.mesh(texture));
  ok &=
      expect(after.vertices == before.vertices - 1 && after.faces == before.faces - 2, "the surface follows");
  ok &= expect(charts_after.vertices == charts.vertices - 2 && charts_after.faces == after.faces,
               "both sides follow");
  ok &= expect(report(curves).edges == seam_edges - 1 && charts_after.components == charts.components,
               "so does the curve");

  // Illegal: collapsing an edge from seam to seam across a chart, and moving a point of a seam to the place
  // of the vertex beside it.
  Outcome across_chart{}, off_seam{};
  for (Index e = 0; e < root.capacity(1); ++e) {
    if (!root.is_live(1, e) || tree.has_preimage(NodeId::root, root.dart_of(1, e), 1, seams)) continue;
    const Dart a = root.dart_of(1, e), b = root.switch_dart(a, 0);
    const bool at_a = tree.has_preimage(NodeId::root, a, 0, seams),
               at_b = tree.has_preimage(NodeId::root, b, 0, seams);
    if (at_a && at_b && root.link_condition(a) && !across_chart.refusal.refused())
      across_chart = propagation.collapse(NodeId::root, a);
    if (at_a && !at_b && root.link_condition(a) && !off_seam.refusal.refused())
      off_seam = propagation.collapse(NodeId::root, a, Placement::keep_b());
  }
  ok &= expect(across_chart.refusal.check == Check::link_condition && across_chart.refusal.node == texture,
               "the texture refuses to be pinched");
  ok &= expect(off_seam.refusal.check == Check::placement, "the seam keeps its place");
  ok &= expect(report(root).faces == after.faces && validate(tree).empty(), "refusals change nothing");
  std::cout << "across a chart: " << to_string(across_chart.refusal.check)
            << "; off the seam: " << to_string(off_seam.refusal.check) << '\n';
  return ok ? 0 : 1;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
