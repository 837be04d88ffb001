// SPDX-License-Identifier: BSD-3-Clause
// Tests of the judges on single complexes: known surfaces, broken ones, the link condition, graph types.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "oracle/collapse.hpp"
#include "oracle/complex.hpp"
#include "oracle/gluing.hpp"
#include "oracle/graph_type.hpp"
#include "oracle/random_surface.hpp"

namespace multimesh::oracle {
namespace {

/// n x m vertices on a torus, every square with one diagonal.
Complex grid_torus(int n, int m) {
  Complex torus{2, {}};
  const auto at = [&](int i, int j) { return i % n * m + j % m; };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      torus.facets.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      torus.facets.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return torus;
}

/// The 6-vertex projective plane.
Complex projective_plane() {
  return {2,
          {{1, 2, 3},
           {1, 3, 4},
           {1, 4, 5},
           {1, 5, 6},
           {1, 6, 2},
           {2, 3, 5},
           {3, 4, 6},
           {2, 4, 5},
           {3, 5, 6},
           {2, 4, 6}}};
}

Complex octahedron() {
  return {2, {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

Complex path(int edges) {
  Complex c{1, {}};
  for (int i = 0; i < edges; ++i) c.facets.push_back({i, i + 1, -1});
  return c;
}

Complex cycle(int edges) {
  Complex c = path(edges);
  c.facets.back()[1] = 0;
  return c;
}

Complex both(const Complex& a, Complex b) {
  for (auto& f : b.facets) {
    for (int& v : f) v += 1000;
  }
  b.facets.insert(b.facets.end(), a.facets.begin(), a.facets.end());
  return b;
}

TEST(OracleComplex, KnowsTheClosedSurfaces) {
  EXPECT_EQ(signature(base_surface(Surface::kSphere)), (Signature{2, 0, 1}));
  EXPECT_EQ(signature(octahedron()), (Signature{2, 0, 1}));
  EXPECT_EQ(signature(base_surface(Surface::kTorus)), (Signature{0, 0, 1}));
  EXPECT_EQ(signature(grid_torus(3, 3)), (Signature{0, 0, 1}));
  EXPECT_EQ(signature(projective_plane()), (Signature{1, 0, 0}));
}

TEST(OracleComplex, KnowsTheSurfacesWithBoundary) {
  EXPECT_EQ(signature(base_surface(Surface::kDisk)), (Signature{1, 1, 1}));
  EXPECT_EQ(signature(base_surface(Surface::kAnnulus)), (Signature{0, 2, 1}));
  EXPECT_EQ(signature(base_surface(Surface::kMoebius)), (Signature{0, 1, 0}));
  EXPECT_EQ(signature(base_surface(Surface::kHoledTorus)), (Signature{-1, 1, 1}));
  EXPECT_EQ(boundary_loops(base_surface(Surface::kAnnulus)), (std::vector<int>{3, 3}));
  EXPECT_EQ(boundary_loops(base_surface(Surface::kMoebius)), (std::vector<int>{5}));
}

TEST(OracleComplex, KnowsTheCurves) {
  EXPECT_EQ(signature(path(4)), (Signature{1, 2, 1}));
  EXPECT_EQ(signature(cycle(5)), (Signature{0, 0, 1}));
  EXPECT_EQ(signature(both(path(1), cycle(3))), (Signature{0, 0, 1, 1, 2, 1}));
  EXPECT_EQ(boundary_points(path(3)), (std::vector<int>{0, 3}));
}

TEST(OracleComplex, SignatureAgreesWithCountingBySets) {
  std::mt19937_64 rng(1);
  for (int i = 0; i < 60; ++i) {
    const Complex one = random_surface(static_cast<Surface>(i % kNumberOfSurfaces), 10, rng);
    const Complex two = random_surface(static_cast<Surface>(pick(rng, 6)), 12, rng);
    const Complex c = both(one, two);
    const Signature types = signature(c);
    ASSERT_EQ(types.size(), 6U);
    EXPECT_EQ(number_of_components(c), 2);
    EXPECT_EQ(types[0] + types[3], euler_characteristic(c));
    EXPECT_EQ(types[1] + types[4], static_cast<std::int64_t>(boundary_loops(c).size()));
    EXPECT_EQ(types[2] == 1 && types[5] == 1, is_orientable(c));
  }
}

TEST(OracleComplex, StarAndLinkOfTheOctahedronsVertexAndEdge) {
  const SimplexSet K = simplices(octahedron());
  EXPECT_EQ(star(K, simplex({4})).size(), 9U);  // itself, 4 edges, 4 facets
  EXPECT_EQ(of_dimension(link(K, simplex({4})), 1),
            (SimplexSet{simplex({0, 2}), simplex({0, 3}), simplex({1, 2}), simplex({1, 3})}));
  EXPECT_EQ(link(K, simplex({0, 4})), (SimplexSet{simplex({2}), simplex({3})}));
}

TEST(OracleComplex, ConeOnTheBoundaryClosesADisk) {
  const Complex disk = base_surface(Surface::kDisk);
  const SimplexSet closed = with_cone(simplices(disk), boundary(disk));
  EXPECT_EQ(closed, simplices(Complex{2, {{0, 1, 2}, {kOmega, 0, 1}, {kOmega, 1, 2}, {kOmega, 0, 2}}}));
}

TEST(OracleComplex, EachDefectOfAManifoldIsReported) {
  EXPECT_NE(manifold_error({2, {}}), "");
  EXPECT_NE(manifold_error({2, {{0, 1, 1}}}), "");
  EXPECT_NE(manifold_error({2, {{0, 1, 2}, {2, 0, 1}}}), "");
  EXPECT_NE(manifold_error({2, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}}), "");  // a book of three pages
  EXPECT_NE(manifold_error({2, {{0, 1, 2}, {0, 3, 4}}}), "");             // a bow tie
  EXPECT_NE(manifold_error({1, {{0, 1, -1}, {0, 2, -1}, {0, 3, -1}}}), "");
  EXPECT_NE(manifold_error({1, {{0, 1, -1}, {1, 0, -1}}}), "");
  EXPECT_NE(manifold_error({1, {{0, 0, -1}}}), "");
}

TEST(OracleGluing, NormalizesAPinchedSurface) {
  const Complex bow_tie{2, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(pinched_vertices(glue(bow_tie)), (std::vector<int>{0}));
  EXPECT_EQ(signature(regions(glue(bow_tie)).types), (Signature{1, 1, 1, 1, 1, 1}));
}

TEST(OracleGluing, CutsATorusAlongACycleIntoAnAnnulus) {
  SimplexSet ring{simplex({0, 1}), simplex({1, 2}), simplex({0, 2})};  // one row of the grid
  normalize(ring);
  EXPECT_EQ(signature(regions(glue(grid_torus(3, 3), ring)).types), (Signature{0, 2, 1}));
}

TEST(OracleLinkCondition, TooSmallSurfacesHaveNoCollapse) {
  for (const Complex& c :
       {base_surface(Surface::kSphere), base_surface(Surface::kTorus), grid_torus(3, 3),
        base_surface(Surface::kDisk), base_surface(Surface::kMoebius), projective_plane()}) {
    for (const Simplex& e : simplices(c, 1)) EXPECT_FALSE(link_condition(c, e.v[0], e.v[1])) << to_string(e);
  }
}

TEST(OracleLinkCondition, EveryEdgeOfOctahedronAndFourByFourTorus) {
  for (const Complex& c : {octahedron(), grid_torus(4, 4)}) {
    for (const Simplex& e : simplices(c, 1)) EXPECT_TRUE(link_condition(c, e.v[0], e.v[1])) << to_string(e);
  }
}

// 3---2
// | / |   The diagonal joins two boundary points through the inside; a side may go.
// 0---1
TEST(OracleLinkCondition, RefusesAnInteriorEdgeBetweenBoundaryPoints) {
  const Complex square{2, {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_FALSE(link_condition(square, 0, 2));
  EXPECT_TRUE(link_condition(square, 0, 1));
}

TEST(OracleLinkCondition, OfCurves) {
  EXPECT_FALSE(link_condition(path(1), 0, 1));
  EXPECT_TRUE(link_condition(path(2), 0, 1));
  EXPECT_FALSE(link_condition(cycle(3), 0, 1));
  EXPECT_TRUE(link_condition(cycle(4), 0, 1));
}

// Dey et al. 1999: on a 2-manifold the condition holds exactly when the contraction keeps the surface.
TEST(OracleLinkCondition, HoldsExactlyWhenIdentificationKeepsTheSurface) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    std::mt19937_64 rng(seed);
    const Complex c = random_surface(static_cast<Surface>(seed % kNumberOfSurfaces), 8 + pick(rng, 16), rng);
    for (const Simplex& e : simplices(c, 1)) {
      const CollapseResult result = collapse({{{c, -1, {}}}}, e.v[0], e.v[1]);
      const bool kept = result.valid && signature(result.tree.nodes[0].mesh) == signature(c);
      EXPECT_EQ(link_condition(c, e.v[0], e.v[1]), kept) << "seed " << seed << " edge " << to_string(e);
    }
  }
}

LabelledGraph graph_of(const std::vector<std::array<int, 2>>& edges) {
  LabelledGraph g;
  for (const auto& [from, to] : edges) {
    g.edges.push_back({from, to, 1, 7});
    g.vertices[from] = g.vertices[to] = 7;
  }
  return g;
}

TEST(OracleGraphType, ForgetsOrdinaryVerticesOnly) {
  EXPECT_EQ(graph_type(graph_of({{0, 1}})), graph_type(graph_of({{5, 1}, {1, 2}, {2, 9}})));
  EXPECT_EQ(graph_type(graph_of({{0, 1}, {1, 2}, {2, 0}})),
            graph_type(graph_of({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 0}})));
  LabelledGraph marked = graph_of({{0, 1}, {1, 2}});
  marked.vertices[1] = 8;
  EXPECT_NE(graph_type(marked), graph_type(graph_of({{0, 1}, {1, 2}})));
  LabelledGraph two_kinds = graph_of({{0, 1}, {1, 2}});
  two_kinds.edges[1].label = 2;
  EXPECT_NE(graph_type(two_kinds), graph_type(graph_of({{0, 1}, {1, 2}})));
}

// theta: two vertices, three arcs.  dumbbell: two loops, joined by an arc.  eight: two loops at one vertex.
TEST(OracleGraphType, TellsThetaDumbbellAndEightApart) {
  const Signature theta = graph_type(graph_of({{0, 1}, {0, 2}, {2, 1}, {0, 3}, {3, 1}}));
  const Signature dumbbell = graph_type(graph_of({{0, 1}, {0, 2}, {2, 3}, {3, 0}, {1, 4}, {4, 5}, {5, 1}}));
  const Signature eight = graph_type(graph_of({{0, 1}, {1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}}));
  EXPECT_NE(theta, dumbbell);
  EXPECT_NE(theta, eight);
  EXPECT_NE(dumbbell, eight);
}

TEST(OracleRandomSurface, KeepsItsTypeAndVaries) {
  std::mt19937_64 rng(3);
  for (int kind = 0; kind < kNumberOfSurfaces; ++kind) {
    const auto surface = static_cast<Surface>(kind);
    std::vector<std::size_t> sizes;
    for (int i = 0; i < 20; ++i) {
      const Complex c = random_surface(surface, 8 + pick(rng, 20), rng);
      EXPECT_EQ(manifold_error(c), "");
      EXPECT_EQ(signature(c), signature(base_surface(surface)));
      EXPECT_LE(c.facets.size(), 40U);
      sizes.push_back(simplices(c, 0).size());
    }
    std::sort(sizes.begin(), sizes.end());
    EXPECT_LT(sizes.front(), sizes.back());
  }
}

}  // namespace
}  // namespace multimesh::oracle
