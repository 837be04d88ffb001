// SPDX-License-Identifier: BSD-3-Clause
// Sharp edges and the boundary as meshes of their own. An open box is decimated as far as topology allows;
// its edges and corners stay where they are, because meshes hold them.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <array>
#include <iostream>
#include <map>

#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/build.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;
using OpenMesh::Vec3d;
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

constexpr int n = 6;  // squares along an edge of the box

UserMesh open_box() {
  UserMesh mesh;
  std::map<std::array<int, 3>, OpenMesh::VertexHandle> known;
  const auto at = [&](int x, int y, int z) {
    auto& v = known[{x, y, z}];
    if (!v.is_valid()) v = mesh.add_vertex(Vec3d(x, y, z));
    return v;
  };
  const auto square = [&](auto a, auto b, auto c, auto d) { mesh.add_face(a, b, c), mesh.add_face(a, c, d); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {  // no lid at z = n
      square(at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0));
      square(at(i, 0, j), at(i + 1, 0, j), at(i + 1, 0, j + 1), at(i, 0, j + 1));
      square(at(i, n, j), at(i, n, j + 1), at(i + 1, n, j + 1), at(i + 1, n, j));
      square(at(0, i, j), at(0, i, j + 1), at(0, i + 1, j + 1), at(0, i + 1, j));
      square(at(n, i, j), at(n, i + 1, j), at(n, i + 1, j + 1), at(n, i, j + 1));
    }
  return mesh;
}

bool expect(bool fact, const char* what) {
  if (!fact) std::cerr << "wrong: " << what << '\n';
  return fact;
}

int main() {
  UserMesh box = open_box();
  const auto sharp = [&](Index e) {  // more than 45 degrees between the faces beside the edge
    const auto h = box.halfedge_handle(OpenMesh::EdgeHandle(static_cast<int>(e)), 0);
    return !box.is_boundary(box.edge_handle(h)) && std::abs(box.calc_dihedral_angle(h)) > 0.25 * M_PI;
  };
  MultiMesh tree(std::make_unique<openmesh::TriangleMesh>(box));
  const Mesh& root = tree.mesh(NodeId::root);
  const NodeId sharp_edges = add_child_from_tags(tree, NodeId::root, 1, sharp, openmesh::make_mesh);
  // The curves are cut at the four corners of the bottom: 4 chains there, 4 up to the rim.
  bool ok = expect(report(tree.mesh(sharp_edges)).components == 8, "eight chains");

  // An edge from a sharp edge to the rim may be collapsed, unless new contacts are forbidden.
  Propagation propagation(tree);
  std::size_t contacts = 0;
  for (Index e = 0; e < root.capacity(1); ++e) {
    const Dart d = root.dart_of(1, e);
    const bool allowed = !propagation.set({.contact = false}).judge(NodeId::root, d).refusal.refused();
    const Refusal r = propagation.set({.contact = true}).judge(NodeId::root, d).refusal;
    contacts += allowed && r.check == Check::contact;
  }
  ok &= expect(contacts > 0, "sharp edges would touch the rim");

  const NodeId rim = add_child_from_boundary(tree, NodeId::root, openmesh::make_mesh);
  ok &= expect(report(tree.mesh(rim)).boundary == 0 && tree.children(NodeId::root).size() == 2,
               "the rim is a loop");
  VertexAttribute position(NodeId::root, box.property(box.points_property_handle()).data_vector());
  propagation.add(position);

  // An operation that is requested on a curve is also done on the surface.
  const Outcome split = propagation.split(rim, tree.mesh(rim).dart_of(1, 0), 0.25);
  ok &= expect(split && report(root).faces == 10 * n * n + 1, "split of the rim");

  for (bool changed = true; changed;) {
    changed = false;
    for (Index e = 0; e < root.capacity(1); ++e)
      if (root.is_live(1, e)) changed |= bool(propagation.collapse(NodeId::root, root.dart_of(1, e)));
  }
  ok &= expect(validate(tree).empty() && report(tree.mesh(sharp_edges)).components == 8,
               "eight chains are left");
  ok &= expect(report(tree.mesh(sharp_edges)).edges == 8 && report(tree.mesh(rim)).edges == 4,
               "of one edge each");
  tree.compact();
  ok &= expect(box.n_vertices() == 8, "the corners are left");
  for (const auto v : box.vertices())
    for (const double x : box.point(v)) ok &= expect(x == 0 || x == n, "where they were");
  std::cout << 10 * n * n << " faces -> " << box.n_faces() << "; contacts refused: " << contacts << '\n';
  return ok ? 0 : 1;
}
