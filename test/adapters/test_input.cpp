// SPDX-License-Identifier: BSD-3-Clause
// Input that cannot be a mesh of a tree is refused, naming the element, and left unchanged.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>

#include "multimesh/error.hpp"
#include "multimesh/openmesh/edge_mesh.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"

namespace multimesh::test {
namespace {

using OpenMesh::PolyConnectivity;
using OpenMesh::VertexHandle;

PolyConnectivity poly(int vertices, const std::vector<std::vector<int>>& faces) {
  PolyConnectivity om;
  om.resize(static_cast<std::size_t>(vertices), 0, 0);
  for (const auto& f : faces) {
    std::vector<VertexHandle> corners;
    for (const int v : f) corners.emplace_back(v);
    om.add_face(corners);
  }
  return om;
}

/// Edges joined to curves as EdgeMesh describes: each halfedge's successor is given.
PolyConnectivity curve(int vertices, const std::vector<std::array<int, 2>>& edges,
                       const std::vector<int>& next) {
  PolyConnectivity om;
  om.resize(static_cast<std::size_t>(vertices), 0, 0);
  for (const auto& e : edges) {
    const auto h = om.new_edge(VertexHandle(e[0]), VertexHandle(e[1]));
    om.set_halfedge_handle(VertexHandle(e[0]), h);
    om.set_halfedge_handle(VertexHandle(e[1]), om.opposite_halfedge_handle(h));
  }
  for (int h = 0; h < static_cast<int>(next.size()); ++h)
    om.set_next_halfedge_handle(OpenMesh::HalfedgeHandle(h),
                                OpenMesh::HalfedgeHandle(next[static_cast<std::size_t>(h)]));
  return om;
}

template <class MeshType>
void expect_refused(PolyConnectivity om, const std::string& named) {
  const bool had_status = om.has_vertex_status();
  try {
    const MeshType mesh(om);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(named), std::string::npos) << e.what();
  }
  EXPECT_EQ(om.has_vertex_status(), had_status);
  for (auto p = om.vprops_begin(); p != om.vprops_end(); ++p)
    EXPECT_TRUE(!*p || (*p)->name().rfind("mm:", 0) != 0);
}

TEST(TriangleMeshInput, RefusesAQuad) {
  expect_refused<openmesh::TriangleMesh>(poly(5, {{0, 1, 2}, {0, 2, 3, 4}}), "face 1");
}

//   1---0---4
//    \ / \ /
//     2   3
TEST(TriangleMeshInput, RefusesAPinchedVertex) {
  expect_refused<openmesh::TriangleMesh>(poly(5, {{0, 1, 2}, {0, 3, 4}}), "vertex 0");
}

// Two closed fans at one vertex: OpenMesh's add_face does not make them, but other code can. is_manifold()
// does not detect them, because it walks around only one fan.
TEST(TriangleMeshInput, RefusesTwoTetrahedraThatShareAVertex) {
  PolyConnectivity om =
      poly(8, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {4, 5, 6}, {4, 6, 7}, {4, 7, 5}, {5, 7, 6}});
  for (const auto h : om.all_halfedges())
    if (om.to_vertex_handle(h).idx() == 4) om.set_vertex_handle(h, VertexHandle(0));
  om.set_isolated(VertexHandle(4));
  expect_refused<openmesh::TriangleMesh>(om, "vertex 0");
}

// A simplex is determined by its vertices: a face and its reverse are one simplex twice.
TEST(TriangleMeshInput, RefusesAPillow) {
  expect_refused<openmesh::TriangleMesh>(poly(3, {{0, 1, 2}, {2, 1, 0}}), "face");
}

TEST(EdgeMeshInput, TakesChainsAndLoops) {
  PolyConnectivity chain = curve(3, {{0, 1}, {1, 2}}, {2, 0, 3, 1});
  EXPECT_NO_THROW(openmesh::EdgeMesh{chain});
  PolyConnectivity loop = curve(3, {{0, 1}, {1, 2}, {2, 0}}, {2, 5, 4, 1, 0, 3});
  EXPECT_NO_THROW(openmesh::EdgeMesh{loop});
}

TEST(EdgeMeshInput, RefusesABranch) {
  expect_refused<openmesh::EdgeMesh>(curve(4, {{0, 1}, {0, 2}, {0, 3}}, {1, 2, 3, 4, 5, 0}), "");
}

TEST(EdgeMeshInput, RefusesFaces) {
  expect_refused<openmesh::EdgeMesh>(poly(3, {{0, 1, 2}}), "halfedge");
}

TEST(EdgeMeshInput, RefusesAnEdgeFromAVertexToItself) {
  expect_refused<openmesh::EdgeMesh>(curve(1, {{0, 0}}, {0, 1}), "loop");
}

// A loop of two edges: both have the same vertices.
TEST(EdgeMeshInput, RefusesADoubleEdge) {
  expect_refused<openmesh::EdgeMesh>(curve(2, {{0, 1}, {1, 0}}, {2, 3, 0, 1}), "");
}

TEST(MakeMesh, NamesTheFacetThatDoesNotFit) {
  const auto message = [](const FacetList& list) {
    try {
      (void)openmesh::make_mesh(list);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  EXPECT_NE(message({2, 5, {0, 1, 2, 1, 0, 3, 0, 1, 4}}).find("facet 2"), std::string::npos);
  EXPECT_NE(message({2, 5, {0, 1, 2, 0, 3, 4}}).find("vertex 0"), std::string::npos);
  EXPECT_NE(message({1, 4, {0, 1, 0, 2, 0, 3}}).find("edge 2"), std::string::npos);
}

TEST(MakeMesh, KeepsTheNumbersOfFacetsAndVertices) {
  const FacetList list{2, 6, {5, 1, 2, 2, 3, 5}};  // vertices 0 and 4 have no facet
  const auto mesh = openmesh::make_mesh(list);
  ASSERT_EQ(mesh->capacity(0), 6U);
  for (Index f = 0; f < 2; ++f) EXPECT_NE(dart_with(*mesh, f, list.facet(f).data()), no_dart);
  EXPECT_EQ(mesh->dart_of(0, 0), no_dart);
}

TEST(Attachment, ASecondTimeIsAUsageErrorUntilTheFirstIsGone) {
  PolyConnectivity om = poly(3, {{0, 1, 2}});
  {
    const openmesh::TriangleMesh first(om);
    EXPECT_THROW(openmesh::TriangleMesh{om}, UsageError);
    EXPECT_THROW(openmesh::EdgeMesh{om}, UsageError);
    EXPECT_TRUE(om.has_vertex_status());
  }
  EXPECT_FALSE(om.has_vertex_status());
  EXPECT_NO_THROW(openmesh::TriangleMesh{om});
}

}  // namespace
}  // namespace multimesh::test
