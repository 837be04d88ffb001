// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "multimesh/cut.hpp"
#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/support/solids.hpp"

namespace multimesh::test {
namespace {

oracle::Complex complex_of_list(const FacetList& list) {
  oracle::Complex c{list.dimension, {}};
  for (std::size_t f = 0; f < list.size(); ++f) {
    const auto v = list.facet(f);
    oracle::Facet facet{};
    std::transform(v.begin(), v.end(), facet.begin(), [](Index i) { return static_cast<int>(i); });
    c.facets.push_back(facet);
  }
  return c;
}

/// Everything that cut() guarantees for any input.
void expect_cut(const FacetList& in, const Cut& out) {
  ASSERT_EQ(out.facets.size(), in.size());
  ASSERT_EQ(out.reversed.size(), in.size());
  ASSERT_EQ(out.source.size(), out.facets.vertices);
  for (std::size_t f = 0; f < in.size(); ++f) {
    std::vector<Index> back;
    for (const Index v : out.facets.facet(f)) back.push_back(out.source.at(v));
    if (out.reversed[f]) std::swap(back[0], back[1]);
    EXPECT_TRUE(std::equal(back.begin(), back.end(), in.facet(f).begin())) << "facet " << f;
  }
  const oracle::Complex made = complex_of_list(out.facets);
  EXPECT_EQ(oracle::manifold_error(made), "");
  EXPECT_TRUE(oracle::is_orientable(made));
  const MultiMesh tree(make_mesh(out.facets));
  EXPECT_EQ(validate(tree), std::vector<std::string>{});
}

Cut checked_cut(const FacetList& in, const CutOptions& options = {}) {
  Cut out = cut(in, options);
  expect_cut(in, out);
  return out;
}

long components(const Cut& c) {
  return oracle::number_of_components(complex_of_list(c.facets));
}

TEST(Cut, KeepsAManifoldMeshAsItIs) {
  const FacetList sphere_list = sphere(1).facets;
  const Cut c = checked_cut(sphere_list);
  EXPECT_EQ(c.facets.vertices, sphere_list.vertices);
  EXPECT_EQ(std::count(c.reversed.begin(), c.reversed.end(), true), 0);
}

TEST(Cut, DropsVerticesWithoutFacets) {
  const Cut c = checked_cut({2, 9, {8, 3, 5}});
  EXPECT_EQ(c.facets.vertices, 3U);
  EXPECT_EQ(std::set<Index>(c.source.begin(), c.source.end()), (std::set<Index>{3, 5, 8}));
}

//      2   The edge 0-1 has three triangles: 2, 3 and 4 are their apexes.
//     /|
//    0-+-1--...
TEST(Cut, SeparatesTheTrianglesOfANonManifoldEdge) {
  const Cut c = checked_cut(triangles({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(components(c), 3);
}

//   1---0---4     two triangles that share only a vertex
//    \ / \ /
//     2   3
TEST(Cut, DoublesAPinchedVertex) {
  const Cut c = checked_cut(triangles({{0, 1, 2}, {0, 3, 4}}));
  EXPECT_EQ(c.facets.vertices, 6U);
  EXPECT_EQ(components(c), 2);
}

TEST(Cut, DoublesThePointWhereTwoTetrahedraTouch) {
  const Cut c = checked_cut(
      triangles({{0, 1, 2}, {0, 4, 5}, {0, 2, 3}, {0, 5, 6}, {0, 3, 1}, {0, 6, 4}, {1, 3, 2}, {4, 6, 5}}));
  EXPECT_EQ(c.facets.vertices, 8U);
  EXPECT_EQ(components(c), 2);
}

TEST(Cut, TurnsTrianglesToAgree) {
  const Cut c = checked_cut(triangles({{0, 1, 2}, {0, 1, 3}}));
  EXPECT_EQ(components(c), 1);
  EXPECT_NE(c.reversed[0], c.reversed[1]);
}

TEST(Cut, OpensAMoebiusStrip) {
  const Cut c = checked_cut(triangles({{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}}));
  EXPECT_TRUE(oracle::is_orientable(complex_of_list(c.facets)));
  EXPECT_EQ(components(c), 1) << "one cut across the strip is enough";
  EXPECT_EQ(c.facets.vertices, 7U);
}

// The projective plane on six vertices: no cut along boundary edges exists, it has none.
TEST(Cut, OpensAProjectivePlane) {
  const Cut c = checked_cut(triangles({{0, 1, 2},
                                       {0, 2, 3},
                                       {0, 3, 4},
                                       {0, 4, 5},
                                       {0, 5, 1},
                                       {1, 2, 4},
                                       {2, 3, 5},
                                       {3, 4, 1},
                                       {4, 5, 2},
                                       {5, 1, 3}}));
  EXPECT_TRUE(oracle::is_orientable(complex_of_list(c.facets)));
}

TEST(Cut, SeparatesFacetsWithTheSameVertices) {
  EXPECT_EQ(components(checked_cut(triangles({{0, 1, 2}, {0, 1, 2}}))), 2);
  EXPECT_EQ(components(checked_cut(triangles({{0, 1, 2}, {2, 1, 0}}))), 2) << "a face and its reverse";
  EXPECT_EQ(components(checked_cut(triangles({{0, 1, 2}, {1, 2, 0}, {2, 1, 0}}))), 3);
}

TEST(Cut, LeavesAClosedSurfaceWholeUnderAFin) {
  FacetList list = sphere(0).facets;
  const std::size_t closed = list.size();
  const Index a = list.corners[0], b = list.corners[1];
  list.corners.insert(list.corners.end(), {a, b, list.vertices++});
  const Cut c = checked_cut(list);
  EXPECT_EQ(components(c), 2);
  EXPECT_EQ(c.facets.vertices, 6U + 3U);
  EXPECT_EQ(c.facets.size(), closed + 1);
}

/// Two tetrahedra on each side of a face, and one more on the face: three of them there.
TEST(CutOfSolids, SeparatesTheTetrahedraOfANonManifoldFace) {
  const Cut c = checked_cut({3, 6, {0, 1, 2, 3, 1, 0, 2, 4, 0, 1, 2, 5}});
  EXPECT_EQ(components(c), 3);
}

TEST(CutOfSolids, PartsAnEdgeAndAVertexWhereTwoTetrahedraTouch) {
  const Cut at_edge = checked_cut({3, 6, {0, 1, 2, 3, 0, 1, 4, 5}});
  EXPECT_EQ(at_edge.facets.vertices, 8U);
  const Cut at_vertex = checked_cut({3, 7, {0, 1, 2, 3, 0, 4, 5, 6}});
  EXPECT_EQ(at_vertex.facets.vertices, 8U);
}

TEST(CutOfSolids, TurnsTetrahedraToAgree) {
  const Cut c = checked_cut({3, 5, {0, 1, 2, 3, 0, 1, 2, 4}});
  EXPECT_EQ(components(c), 1);
  EXPECT_NE(c.reversed[0], c.reversed[1]);
}

TEST(CutOfSolids, SeparatesFacetsWithTheSameVertices) {
  EXPECT_EQ(components(checked_cut({3, 4, {0, 1, 2, 3, 1, 0, 2, 3}})), 2);
}

TEST(Cut, RefusesADegenerateFacetByItsNumber) {
  try {
    (void)cut(triangles({{0, 1, 2}, {3, 1, 3}}));
    FAIL() << "accepted";
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find("facet 1"), std::string::npos) << e.what();
    EXPECT_NE(std::string(e.what()).find("vertex 3"), std::string::npos) << e.what();
  }
}

TEST(Cut, RefusesVertexNumbersOutOfRange) {
  EXPECT_THROW((void)cut({2, 3, {0, 1, 3}}), InputError);
  EXPECT_THROW((void)cut({3, 4, {0, 1, 2, 4}}), InputError);
}

//      1---0---2      Curves end where more or fewer than two edges meet.
//          |
//          3
TEST(CutOfCurves, EndsAtABranch) {
  const Cut c = checked_cut(segments({{0, 1}, {2, 0}, {0, 3}}));
  EXPECT_EQ(c.facets.vertices, 6U);
  EXPECT_EQ(components(c), 3);
}

TEST(CutOfCurves, JoinsEdgesWhateverTheirDirection) {
  const Cut c = checked_cut(segments({{0, 1}, {2, 1}, {2, 3}}));
  EXPECT_EQ(c.facets.vertices, 4U);
}

TEST(CutOfCurves, EndsWhereItIsTold) {
  const Cut c = checked_cut(segments({{0, 1}, {1, 2}, {2, 0}}), {.ends_at = [](Index v) { return v == 1; }});
  EXPECT_EQ(c.facets.vertices, 4U);
  EXPECT_EQ(components(c), 1);
}

TEST(CutOfCurves, SeparatesADoubleEdge) {
  EXPECT_EQ(components(checked_cut(segments({{0, 1}, {1, 0}}))), 2);
  EXPECT_EQ(components(checked_cut(segments({{0, 1}, {0, 1}, {0, 1}}))), 3);
}

TEST(CutOfCurves, RefusesAnEdgeFromAVertexToItself) {
  EXPECT_THROW((void)cut(segments({{0, 1}, {2, 2}})), InputError);
}

FacetList soup(int dimension, Index vertices, std::size_t facets, std::mt19937& random) {
  FacetList list{dimension, vertices, {}};
  while (list.size() < facets) {
    std::set<Index> v;
    while (v.size() <= static_cast<std::size_t>(dimension)) v.insert(static_cast<Index>(random() % vertices));
    std::vector<Index> corners(v.begin(), v.end());
    std::shuffle(corners.begin(), corners.end(), random);
    list.corners.insert(list.corners.end(), corners.begin(), corners.end());
  }
  return list;
}

TEST(Cut, MakesAnySoupAManifoldProperComplex) {
  std::mt19937 random(1);
  for (int i = 0; i < 6000; ++i) {
    const int dimension = 1 + i % 3;
    const auto vertices = static_cast<Index>(5 + random() % 7);
    const FacetList list = soup(dimension, vertices, 1 + random() % 30, random);
    const CutOptions options{i % 3 == 0 ? [](Index v) { return v % 4 == 0; } : std::function<bool(Index)>{}};
    SCOPED_TRACE("soup " + std::to_string(i));
    ASSERT_NO_FATAL_FAILURE(checked_cut(list, options));
    if (HasFailure()) return;
  }
}

// Manifold input stays in one piece, however its facets are ordered and oriented.
TEST(Cut, KeepsShuffledMeshesWhole) {
  std::mt19937 random(2);
  for (const Shape& s : {grid(3, 4), annulus(4, 2), torus(4, 4), sphere(1), disk(6), six_cycle(),
                         box(2, 1, 2), layers(annulus(4, 1), 1), layers(sphere(0), 1), torus3(3)})
    for (int i = 0; i < 20; ++i) {
      std::vector<std::vector<Index>> facets;
      for (std::size_t f = 0; f < s.facets.size(); ++f) {
        facets.emplace_back(s.facets.facet(f).begin(), s.facets.facet(f).end());
        std::shuffle(facets.back().begin(), facets.back().end(), random);
      }
      std::shuffle(facets.begin(), facets.end(), random);
      FacetList list{s.facets.dimension, s.facets.vertices, {}};
      for (const auto& f : facets) list.corners.insert(list.corners.end(), f.begin(), f.end());
      const Cut c = checked_cut(list);
      EXPECT_EQ(c.facets.vertices, list.vertices);
    }
}

}  // namespace
}  // namespace multimesh::test
