// SPDX-License-Identifier: BSD-3-Clause
// The connectivity that make_mesh sets word by word is the one that OpenMesh's add_face builds.
#include <gtest/gtest.h>

#include <OpenMesh/Core/Mesh/PolyConnectivity.hh>
#include <algorithm>
#include <optional>
#include <random>

#include "multimesh/error.hpp"
#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/openmesh/make_mesh.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {
namespace {

using OpenMesh::PolyConnectivity;

/// Nothing if OpenMesh does not take the facets in this order.
std::optional<PolyConnectivity> by_add_face(const FacetList& list) {
  PolyConnectivity om;
  om.resize(list.vertices, 0, 0);
  ::omerr().disable();
  bool taken = true;
  for (std::size_t f = 0; taken && f < list.size(); ++f) {
    std::vector<OpenMesh::VertexHandle> corners;
    for (const Index v : list.facet(f)) corners.emplace_back(static_cast<int>(v));
    taken = om.add_face(corners).is_valid();
  }
  ::omerr().enable();
  if (!taken) return {};
  return om;
}

void expect_equal(const PolyConnectivity& a, const PolyConnectivity& b) {
  ASSERT_EQ(a.n_vertices(), b.n_vertices());
  ASSERT_EQ(a.n_edges(), b.n_edges());
  ASSERT_EQ(a.n_faces(), b.n_faces());
  for (const auto h : a.all_halfedges()) {
    EXPECT_EQ(a.to_vertex_handle(h), b.to_vertex_handle(h)) << "halfedge " << h.idx();
    EXPECT_EQ(a.next_halfedge_handle(h), b.next_halfedge_handle(h)) << "halfedge " << h.idx();
    EXPECT_EQ(a.prev_halfedge_handle(h), b.prev_halfedge_handle(h)) << "halfedge " << h.idx();
    EXPECT_EQ(a.face_handle(h), b.face_handle(h)) << "halfedge " << h.idx();
  }
  for (const auto v : a.all_vertices())
    EXPECT_EQ(a.halfedge_handle(v), b.halfedge_handle(v)) << "vertex " << v.idx();
  for (const auto f : a.all_faces())
    EXPECT_EQ(a.halfedge_handle(f), b.halfedge_handle(f)) << "face " << f.idx();
}

/// Side by side, with two isolated vertices before each.
FacetList together(const std::vector<FacetList>& parts) {
  FacetList all;
  for (const FacetList& part : parts) {
    all.vertices += 2;
    for (const Index v : part.corners) all.corners.push_back(all.vertices + v);
    all.vertices += part.vertices;
  }
  return all;
}

/// Facets in another order, each beginning with any of its corners; orientations stay.
FacetList shuffled(const FacetList& list, std::mt19937& random) {
  std::vector<std::vector<Index>> facets;
  for (std::size_t f = 0; f < list.size(); ++f) {
    facets.emplace_back(list.facet(f).begin(), list.facet(f).end());
    std::rotate(facets.back().begin(), facets.back().begin() + random() % 3, facets.back().end());
  }
  std::shuffle(facets.begin(), facets.end(), random);
  FacetList result{list.dimension, list.vertices, {}};
  for (const auto& f : facets) result.corners.insert(result.corners.end(), f.begin(), f.end());
  return result;
}

std::vector<FacetList> manifold_lists() {
  std::vector<FacetList> lists;
  for (const Shape& s :
       {grid(1, 1), grid(3, 5), annulus(4, 2), torus(4, 5), sphere(0), sphere(2), disk(7), disk(1)})
    lists.push_back(s.facets);
  lists.push_back({2, 4, {0, 1, 2, 0, 2, 3, 0, 3, 1, 3, 2, 1}});  // a tetrahedron
  lists.push_back({2, 3, {0, 1, 2}});
  lists.push_back({2, 5, {}});
  lists.push_back(together(lists));
  return lists;
}

PolyConnectivity& connectivity(Mesh& mesh) {
  return dynamic_cast<openmesh::Connectivity&>(mesh).openmesh();
}

TEST(MakeTriangles, AreThoseOfOpenMeshNumberByNumber) {
  std::mt19937 random(3);
  int compared = 0;
  for (const FacetList& list : manifold_lists())
    for (int i = 0; i < 20; ++i) {
      const FacetList facets = i == 0 ? list : shuffled(list, random);
      const auto made = openmesh::make_mesh(facets);
      std::vector<std::string> problems;
      made->check(problems);
      EXPECT_EQ(problems, std::vector<std::string>{});
      const auto other = by_add_face(facets);
      EXPECT_TRUE(other || i > 0);
      if (!other) continue;
      expect_equal(connectivity(*made), *other);
      ++compared;
      if (HasFailure()) return;
    }
  EXPECT_GT(compared, 100);
}

// All edges to the apex have a common vertex: no step may search them edge by edge.
TEST(MakeTriangles, TakesALargeFan) {
  const FacetList fan = disk(300000).facets;
  EXPECT_EQ(cut(fan).facets.size(), fan.size());
  EXPECT_EQ(openmesh::make_mesh(fan)->capacity(1), 600001U);
}

std::string refusal(const FacetList& list) {
  try {
    (void)openmesh::make_mesh(list);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

void expect_refused(const FacetList& list, const std::string& facet, const std::string& where) {
  const std::string message = refusal(list);
  EXPECT_NE(message.find(facet), std::string::npos) << message;
  EXPECT_NE(message.find(where), std::string::npos) << message;
}

TEST(MakeTriangles, RefusesTheThirdFacetAtAnEdge) {
  expect_refused({2, 5, {0, 1, 2, 1, 0, 3, 0, 1, 4}}, "facet 2", "vertices 0 and 1");
  expect_refused({2, 5, {0, 1, 2, 1, 0, 3, 1, 0, 4}}, "facet 2", "vertices 1 and 0");
}

TEST(MakeTriangles, RefusesNeighboursThatDoNotAgree) {
  expect_refused({2, 4, {0, 1, 2, 0, 1, 3}}, "facet 1", "from vertex 0 to 1");
}

TEST(MakeTriangles, RefusesARepeatedVertex) {
  expect_refused({2, 4, {0, 1, 2, 3, 1, 3}}, "facet 1", "twice");
  expect_refused({2, 4, {0, 1, 2, 3, 3, 1}}, "facet 1", "twice");
}

//   1---0---4     two open fans; then an open and a closed one; then two closed ones
//    \ / \ /
//     2   3
TEST(MakeTriangles, RefusesSeveralFansAtAVertex) {
  const std::vector<Index> open{0, 1, 2}, other{0, 3, 4};
  const std::vector<Index> closed{0, 5, 6, 0, 6, 7, 0, 7, 5, 5, 7, 6},
      second{8, 0, 9, 9, 0, 10, 10, 0, 8, 8, 9, 10};
  const auto list = [](const std::vector<Index>& a, const std::vector<Index>& b) {
    FacetList both{2, 11, a};
    both.corners.insert(both.corners.end(), b.begin(), b.end());
    return both;
  };
  expect_refused(list(open, other), "facet 1", "vertex 0");
  expect_refused(list(open, closed), "facet 1", "vertex 0");
  expect_refused(list(closed, open), "facet 4", "vertex 0");
  expect_refused(list(closed, second), "facet 4", "vertex 0");
}

}  // namespace
}  // namespace multimesh::test
