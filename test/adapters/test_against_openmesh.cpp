// SPDX-License-Identifier: BSD-3-Clause
// Our local operations have the same results as OpenMesh's: the same handles survive, joined the same way.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/TriConnectivity.hh>
#include <algorithm>
#include <random>

#include "multimesh/openmesh/triangle_mesh.hpp"
#include "oracle/random_surface.hpp"
#include "test/core/bridge.hpp"

namespace multimesh::test {
namespace {

using OpenMesh::EdgeHandle;
using OpenMesh::HalfedgeHandle;
using OpenMesh::TriConnectivity;
using OpenMesh::VertexHandle;

TriConnectivity connectivity(const FacetList& list) {
  TriConnectivity om;
  om.request_vertex_status(), om.request_edge_status(), om.request_halfedge_status(),
      om.request_face_status();
  om.resize(list.vertices, 0, 0);
  for (std::size_t f = 0; f < list.size(); ++f) {
    std::vector<VertexHandle> corners;
    for (const Index v : list.facet(f)) corners.emplace_back(static_cast<int>(v));
    om.add_face(corners);
  }
  return om;
}

/// Live handles and their connections; the outgoing halfedge of a vertex is arbitrary and left out.
std::vector<std::array<int, 5>> joined(const TriConnectivity& om) {
  std::vector<std::array<int, 5>> all;
  for (const auto v : om.all_vertices())
    if (!om.status(v).deleted()) all.push_back({0, v.idx(), 0, 0, 0});
  for (const auto f : om.all_faces())
    if (!om.status(f).deleted()) all.push_back({2, f.idx(), 0, 0, 0});
  for (const auto h : om.all_halfedges())
    if (!om.status(om.edge_handle(h)).deleted())
      all.push_back({1, h.idx(), om.to_vertex_handle(h).idx(), om.face_handle(h).idx(),
                     om.next_halfedge_handle(h).idx()});
  return all;
}

/// Oriented triangles, the smallest vertex first.
std::vector<std::array<int, 3>> triangles_of(const TriConnectivity& om) {
  std::vector<std::array<int, 3>> all;
  for (const auto f : om.all_faces()) {
    if (om.status(f).deleted()) continue;
    std::array<int, 3> v{};
    auto h = om.halfedge_handle(f);
    for (int& x : v) x = om.to_vertex_handle(h).idx(), h = om.next_halfedge_handle(h);
    std::rotate(v.begin(), std::min_element(v.begin(), v.end()), v.end());
    all.push_back(v);
  }
  std::sort(all.begin(), all.end());
  return all;
}

template <class Test>
void on_random_surfaces(const Test& test) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937_64 random(seed);
    const auto list =
        oriented(oracle::random_surface(static_cast<oracle::Surface>(seed % 5), 4 + seed % 20, random));
    SCOPED_TRACE("seed " + std::to_string(seed));
    const TriConnectivity pristine = connectivity(*list);
    TriConnectivity ours = pristine;
    openmesh::TriangleMesh mesh(ours);
    for (int h = 0; h < static_cast<int>(ours.n_halfedges()); ++h) {
      TriConnectivity theirs = pristine;
      const auto mark = mesh.mark();
      test(mesh, ours, theirs, HalfedgeHandle(h));
      mesh.rollback(mark);
      ASSERT_EQ(joined(ours), joined(pristine));
    }
  }
}

TEST(TriangleMesh, CollapsesAsOpenMeshDoes) {
  std::size_t collapsed = 0;
  on_random_surfaces([&](auto& mesh, TriConnectivity& ours, TriConnectivity& theirs, HalfedgeHandle h) {
    const Dart e = mesh.edge_dart(h);
    EXPECT_EQ(mesh.vertex(e), static_cast<Index>(ours.from_vertex_handle(h).idx()));
    if (!mesh.link_condition(e)) return;
    ASSERT_TRUE(theirs.is_collapse_ok(h));
    CollapseRecord record;
    mesh.collapse_edge(e, record);
    theirs.collapse(h);
    EXPECT_EQ(joined(ours), joined(theirs));
    for (const auto v : ours.all_vertices())
      if (!ours.status(v).deleted()) {
        EXPECT_EQ(ours.is_boundary(v), theirs.is_boundary(v));
      }
    ++collapsed;
  });
  EXPECT_GT(collapsed, 100U);
}

TEST(TriangleMesh, SplitsAsOpenMeshDoes) {
  on_random_surfaces([&](auto& mesh, TriConnectivity& ours, TriConnectivity& theirs, HalfedgeHandle h) {
    SplitRecord record;
    mesh.split_edge(mesh.edge_dart(h), record);
    const VertexHandle c = theirs.OpenMesh::ArrayKernel::new_vertex();
    theirs.split(OpenMesh::EdgeHandle(h.idx() / 2), c);
    EXPECT_EQ(static_cast<int>(record.vertex), c.idx());
    EXPECT_EQ(triangles_of(ours), triangles_of(theirs));
    EXPECT_EQ(ours.n_edges(), theirs.n_edges());
    EXPECT_EQ(ours.is_boundary(c), theirs.is_boundary(c));
  });
}

TEST(TriangleMesh, FlipsAsOpenMeshDoes) {
  on_random_surfaces([&](auto& mesh, TriConnectivity& ours, TriConnectivity& theirs, HalfedgeHandle h) {
    const Dart e = mesh.edge_dart(h);
    const OpenMesh::EdgeHandle edge(h.idx() / 2);
    ASSERT_EQ(mesh.can_flip(e), theirs.is_flip_ok(edge));
    if (!mesh.can_flip(e)) return;
    mesh.flip_edge(e);
    theirs.flip(edge);
    EXPECT_EQ(triangles_of(ours), triangles_of(theirs));
  });
}

}  // namespace
}  // namespace multimesh::test
