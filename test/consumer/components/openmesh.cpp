// SPDX-License-Identifier: BSD-3-Clause
// With OpenMesh's tools: headers here are those of modules for its decimaters, too.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include "all_headers.hpp"

bool works() {
  using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
  Mesh mesh;
  for (const float x : {0.F, 1.F, 2.F})
    for (const float y : {0.F, 1.F, 2.F}) mesh.add_vertex({x, y, 0});
  for (const int i : {0, 1, 3, 4}) {
    const OpenMesh::VertexHandle a(i), b(i + 3), c(i + 4), d(i + 1);
    mesh.add_face(a, b, c);
    mesh.add_face(a, c, d);
  }
  multimesh::openmesh::Attached attached(mesh);
  OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
  multimesh::openmesh::ModMultimeshT<Mesh>::Handle module;
  OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadric;
  decimater.add(module);
  decimater.add(quadric);
  decimater.module(module).drive(attached);
  return decimater.initialize() && decimater.decimate(1) == 1;
}
