// SPDX-License-Identifier: BSD-3-Clause
// An existing pipeline: a mesh with the user's own traits and properties becomes part of a multimesh in
// place, in five lines. After 100,000 operations everything is undone, and the mesh is what it was.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Utils/PropertyManager.hh>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "multimesh/openmesh/attach.hpp"
#include "multimesh/validate.hpp"

using namespace multimesh;

struct Traits : OpenMesh::DefaultTraits {  // whatever the pipeline has
  using Point = OpenMesh::Vec3d;
  using Color = OpenMesh::Vec4f;
  HalfedgeAttributes(OpenMesh::Attributes::TexCoord2D);
  FaceAttributes(OpenMesh::Attributes::Color);
};
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// A torus whose texture is cut open along two circles: all its halfedges have texture coordinates.
UserMesh torus(int n, int m) {
  UserMesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m;
      mesh.add_vertex({(2 + cos(b)) * cos(a), (2 + cos(b)) * sin(a), sin(b)});
    }
  const auto face = [&](std::array<std::array<int, 2>, 3> corners) {
    std::vector<OpenMesh::VertexHandle> v;
    for (const auto& [i, j] : corners) v.emplace_back(i % n * m + j % m);
    const auto f = mesh.add_face(v);
    mesh.set_color(f, UserMesh::Color(float(corners[0][0]), float(corners[0][1]), 0, 1));
    for (const auto h : f.halfedges())
      for (const auto& [i, j] : corners)
        if (h.to().idx() == i % n * m + j % m)
          mesh.set_texcoord2D(h, {float(i) / float(n), float(j) / float(m)});
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      face({{{i, j}, {i + 1, j}, {i + 1, j + 1}}}), face({{{i, j}, {i + 1, j + 1}, {i, j + 1}}});
  return mesh;
}

bool same(UserMesh& x, UserMesh& y) {
  const auto values = [](UserMesh& m, auto handle) { return m.property(handle).data_vector(); };
  bool same = x.n_vertices() == y.n_vertices() && x.n_edges() == y.n_edges() && x.n_faces() == y.n_faces();
  same = same && values(x, x.points_pph()) == values(y, y.points_pph());
  same = same && values(x, x.face_colors_pph()) == values(y, y.face_colors_pph());
  same = same && values(x, x.halfedge_texcoords2D_pph()) == values(y, y.halfedge_texcoords2D_pph());
  for (const auto h : x.all_halfedges())
    same = same && x.to_vertex_handle(h) == y.to_vertex_handle(h) &&
           x.next_halfedge_handle(h) == y.next_halfedge_handle(h) && x.face_handle(h) == y.face_handle(h);
  return same;
}

int main() {
  UserMesh mesh = torus(40, 20);
  auto heat = OpenMesh::getOrMakeProperty<OpenMesh::VertexHandle, double>(mesh, "heat");
  for (const auto v : mesh.vertices()) heat[v] = mesh.point(v)[2];
  mesh.request_edge_status();
  for (const auto e : mesh.edges())  // two circles
    mesh.status(e).set_feature(e.v0().idx() % 20 == 10 && e.v1().idx() % 20 == 10);
  UserMesh before = mesh;
  {
    openmesh::Attached attached(mesh);
    const NodeId texture = attached.add_texture();
    const NodeId features = attached.add_features();
    attached.follow(heat.getRawProperty());
    Propagation& operations = attached.operations();

    Transaction undone = operations.transaction();  // never committed
    std::mt19937 random(1);
    while (operations.statistics().done < 100'000) {
      const OpenMesh::SmartEdgeHandle e(static_cast<int>(random() % mesh.n_edges()), &mesh);
      if (mesh.status(e).deleted()) continue;
      const auto what = random() % 5;
      if (what == 0) (void)attached.split(e, 0.25);
      if (what == 1 || what == 2) (void)attached.collapse(e.h0());
      if (what > 2) (void)attached.swap(e);
    }
    double wrong = 0;  // the heat is linear in space, and follows the points
    for (const auto v : mesh.vertices()) wrong = std::max(wrong, std::abs(heat[v] - mesh.point(v)[2]));
    std::cout << "after 100000 operations: " << attached.tree().mesh(texture).capacity(2)
              << " places for faces, " << attached.tree().mesh(features).capacity(1)
              << " for curves' edges; error " << wrong << '\n';
    if (!validate(attached.tree()).empty() || wrong > 1e-12 || same(mesh, before)) return 1;
  }
  return same(mesh, before) && heat[mesh.vertex_handle(0)] == 0 ? 0 : 1;
}
