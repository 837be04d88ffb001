// SPDX-License-Identifier: BSD-3-Clause
// A mesh type of your own as a child of an OpenMesh surface: a polyline in plain vectors (own_mesh.hpp) on a
// sheet. The core depends on neither of the two. test/conformance checks whether such a type keeps its
// contract.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <iostream>
#include <random>

#include "multimesh/openmesh/attach.hpp"
#include "multimesh/validate.hpp"
#include "own_mesh.hpp"

using namespace multimesh;
using UserMesh = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

constexpr int n = 12;

UserMesh sheet() {
  UserMesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) mesh.add_vertex({double(i), double(j), 0});
  const auto at = [](int i, int j) { return OpenMesh::VertexHandle(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1)),
          mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
  return mesh;
}

int main() {
  UserMesh mesh = sheet();
  openmesh::Attached attached(mesh);

  // A polyline of n - 2 edges over the row j = 5: its vertex i lies over the sheet's vertex (i + 1, 5).
  std::vector<std::array<Index, 2>> edges;
  std::vector<Anchor> anchors;
  for (int i = 1; i + 1 < n; ++i) {
    const auto h = mesh.find_halfedge(OpenMesh::VertexHandle(i * (n + 1) + 5),
                                      OpenMesh::VertexHandle((i + 1) * (n + 1) + 5));
    edges.push_back({Index(i - 1), Index(i)});
    anchors.push_back({Dart{2 * Index(edges.size() - 1)}, attached.dart(h)});
  }
  MultiMesh& tree = attached.tree();
  const NodeId line = tree.add_child(NodeId::root, std::make_unique<OwnMesh>(edges), anchors);

  // Operations on the sheet change the polyline, and the other way round.
  Propagation& operations = attached.operations();
  const Outcome split = operations.split(line, tree.mesh(line).dart_of(1, 0), 0.25);
  bool ok = split && mesh.n_vertices() == (n + 1) * (n + 1) + 1;
  std::mt19937 random(1);
  for (int i = 0; i < 3000; ++i) {
    const OpenMesh::EdgeHandle e(static_cast<int>(random() % mesh.n_edges()));
    if (mesh.status(e).deleted()) continue;
    (void)(i % 3 == 0 ? attached.split(e)
                      : attached.collapse(mesh.halfedge_handle(e, 0), Placement::at(0.5)));
    if (i % 500 == 0) attached.garbage_collection();
  }
  ok = ok && validate(tree).empty();

  // The polyline is still one, from where it began to where it ended, along j = 5.
  const Mesh& polyline = tree.mesh(line);
  int length = 0, ends = 0;
  for (Index e = 0; e < polyline.capacity(1); ++e) {
    if (!polyline.is_live(1, e)) continue;
    ++length;
    for (const Dart d : {polyline.dart_of(1, e), polyline.switch_dart(polyline.dart_of(1, e), 0)}) {
      const auto v = mesh.from_vertex_handle(attached.halfedge(tree.to_root(line, d)));
      ok = ok && mesh.point(v)[1] == 5;
      if (!polyline.is_boundary(d, 0)) continue;
      ++ends;
      ok = ok && (mesh.point(v)[0] == 1 || mesh.point(v)[0] == n - 1);
    }
  }
  std::cout << operations.statistics().done << " operations; the polyline has " << length << " edges\n";
  return ok && ends == 2 ? 0 : 1;
}
