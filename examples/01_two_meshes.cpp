// SPDX-License-Identifier: BSD-3-Clause
// Two of the user's OpenMesh meshes, attached in place: a tube, and the rectangle that is rolled into it.
// They have the same faces; the tube's seam is two sides of the rectangle. Operations on one are carried to
// both.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <cmath>
#include <iostream>

#include "multimesh/openmesh/triangle_mesh.hpp"
#include "multimesh/operations.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;
using openmesh::TriangleMesh;
using OpenMesh::Vec3d;

struct Traits : OpenMesh::DefaultTraits {  // whatever the user has
  using Point = Vec3d;
  VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
};
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

constexpr int around = 8, height = 3;

/// Eight columns for the tube, nine for the rectangle; the same faces, in the same order of corners.
template <class Point>
void build(UserMesh& mesh, int columns, Point point) {
  std::vector<OpenMesh::VertexHandle> v;
  for (int row = 0; row <= height; ++row)
    for (int column = 0; column < columns; ++column) v.push_back(mesh.add_vertex(point(column, row)));
  const auto at = [&](int column, int row) {
    return v[static_cast<std::size_t>(row * columns + column % columns)];
  };
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < around; ++column) {
      mesh.add_face(at(column, row), at(column + 1, row), at(column + 1, row + 1));
      mesh.add_face(at(column, row), at(column + 1, row + 1), at(column, row + 1));
    }
}

std::vector<Vec3d>& points(UserMesh& mesh) {
  return mesh.property(mesh.points_property_handle()).data_vector();
}

bool expect(bool fact, const char* what) {
  if (!fact) std::cerr << "wrong: " << what << '\n';
  return fact;
}

int main() {
  UserMesh surface, uv;
  build(surface, around,
        [](int c, int r) { return Vec3d(std::cos(c * 0.25 * M_PI), std::sin(c * 0.25 * M_PI), r); });
  build(uv, around + 1, [](int c, int r) { return Vec3d(c, r, 0); });

  // Face i of one is face i of the other; a dart of each, at corresponding corners, says how they lie.
  std::vector<Anchor> anchors;
  for (const auto f : uv.faces()) {
    const auto own = uv.halfedge_handle(f), above = surface.halfedge_handle(f);
    anchors.push_back({TriangleMesh::dart(own), TriangleMesh::dart(above)});
  }

  MultiMesh tree(std::make_unique<TriangleMesh>(surface));
  const NodeId child = tree.add_child(NodeId::root, std::make_unique<TriangleMesh>(uv), anchors);
  VertexAttribute<Vec3d> position(NodeId::root, points(surface)), texcoord(child, points(uv));
  Propagation propagation(tree);
  propagation.add(position).add(texcoord);

  const auto in_step = [&] {  // the maps are valid, and the height is the same in both meshes
    for (const auto v : uv.vertices()) {
      const Dart image = tree.to_parent(child, tree.mesh(child).dart_of(0, static_cast<Index>(v.idx())));
      if (uv.point(v)[1] != points(surface)[tree.mesh(NodeId::root).vertex(image)][2]) return false;
    }
    return validate(tree).empty();
  };
  bool ok = expect(in_step(), "after construction");

  // On the surface, an edge of the seam: the rectangle has two such edges, and gets two new vertices.
  const OpenMesh::VertexHandle bottom(around), top(2 * around);
  const Dart seam = TriangleMesh::dart(surface.find_halfedge(bottom, top));
  const Outcome split = propagation.split(NodeId::root, seam, 0.25);
  ok &=
      expect(split && surface.n_vertices() == 33 && uv.n_vertices() == 38 && in_step(), "split of the seam");

  // The other way round: the half at the bottom, requested on one of its two sides in the rectangle.
  DartBuffer sides;
  tree.to_child(child, split.dart, 1, sides);
  ok &= expect(sides.size() == 2, "a seam edge has two preimages");
  const Outcome collapse = propagation.collapse(child, sides[0], Placement::keep_a());
  if (!collapse) std::cerr << "refused: " << to_string(collapse.refusal.check) << '\n';
  ok &= expect(bool(collapse) && in_step(), "collapse of half a seam edge");

  tree.compact();
  ok &= expect(surface.n_vertices() == 32 && uv.n_vertices() == 36 && uv.n_faces() == 48, "as before");
  std::cout << surface.n_faces() << " faces; vertices of the tube: " << surface.n_vertices()
            << ", of the rectangle: " << uv.n_vertices() << '\n';
  return ok ? 0 : 1;
}
