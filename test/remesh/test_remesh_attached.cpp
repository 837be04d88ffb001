// SPDX-License-Identifier: BSD-3-Clause
// The same algorithm on a user's own OpenMesh mesh: alone, with a texture, with curves.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/domains/attached_embedding.hpp"
#include "multimesh/validate.hpp"
#include "test/openmesh_tools/textured_torus.hpp"

namespace multimesh::test {
namespace {

using Problems = std::vector<std::string>;

template <class Mesh>
class RemeshAttached : public testing::Test {};
using Meshes = testing::Types<DoubleMesh, FloatMesh>;
TYPED_TEST_SUITE(RemeshAttached, Meshes);

template <class Mesh>
double share_in_range(const Mesh& mesh, double length) {
  std::size_t in = 0;
  for (const auto e : mesh.edges()) {
    const double l = double(mesh.calc_edge_length(e));
    in += l >= 0.8 * length && l <= 4.0 / 3 * length;
  }
  return double(in) / double(mesh.n_edges());
}

TYPED_TEST(RemeshAttached, RunsUnchangedAloneAndInATree) {
  enum Children { none, texture, texture_and_curves };
  for (const bool open : {false, true})
    for (const Children children : {none, texture, texture_and_curves}) {
      SCOPED_TRACE(std::to_string(open) + " " + std::to_string(children));
      TypeParam mesh;
      make_torus(mesh, 30, 20, 2, open);
      openmesh::Attached attached(mesh);
      if (children >= texture) (void)attached.add_texture();
      if (children == texture_and_curves)
        (void)attached.add_edges([&](OpenMesh::EdgeHandle e) {
          const auto h = mesh.halfedge_handle(e, 0);
          const int rows = 20 + open, v = mesh.from_vertex_handle(h).idx(),
                    w = mesh.to_vertex_handle(h).idx();
          return v % rows == 7 && w % rows == 7;
        });
      std::vector<MeshReport> before;
      for (const NodeId n : attached.tree().nodes()) before.push_back(report(attached.tree().mesh(n)));
      RemeshOptions options;
      options.length = 0.25;
      options.iterations = 4;
      const RemeshResult r = remesh(embedding(attached), NodeId::root, options);
      EXPECT_GT(r.moves, 0U);
      EXPECT_EQ(validate(attached.tree()), Problems{});
      attached.garbage_collection();
      EXPECT_GT(share_in_range(mesh, options.length), 0.85);
      std::size_t i = 0;
      for (const NodeId n : attached.tree().nodes()) {
        const MeshReport now = report(attached.tree().mesh(n));
        EXPECT_EQ(now.components, before[i].components);
        EXPECT_EQ(now.euler_characteristic, before[i].euler_characteristic);
        EXPECT_EQ(now.boundary, before[i++].boundary);
      }
      if (children == none) continue;
      EXPECT_EQ(mirrored_triangles(mesh), 0U);
    }
}

// Both ends of each boundary edge, in order; bit by bit.
template <class Mesh>
std::vector<std::array<double, 6>> boundary_edges(const Mesh& mesh) {
  std::vector<std::array<double, 6>> list;
  for (const auto h : mesh.halfedges()) {
    if (!h.is_boundary()) continue;
    const auto p = mesh.point(h.from()), q = mesh.point(h.to());
    list.push_back({double(p[0]), double(p[1]), double(p[2]), double(q[0]), double(q[1]), double(q[2])});
  }
  std::sort(list.begin(), list.end());
  return list;
}

TYPED_TEST(RemeshAttached, KeepsALockedBoundaryEdgeByEdge) {
  for (const bool locked : {true, false}) {
    TypeParam mesh;
    make_torus(mesh, 30, 20, 2, true);
    const auto before = boundary_edges(mesh);
    openmesh::Attached attached(mesh);
    RemeshOptions options;
    options.length = 0.15;
    options.iterations = 3;
    options.lock_boundary = locked;
    (void)remesh(embedding(attached), NodeId::root, options);
    attached.garbage_collection();
    EXPECT_EQ(boundary_edges(mesh) == before, locked);
    for (const auto v : mesh.vertices()) EXPECT_FALSE(mesh.status(v).locked());
  }
}

}  // namespace
}  // namespace multimesh::test
