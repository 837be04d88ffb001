// SPDX-License-Identifier: BSD-3-Clause
// Topology of lists of tetrahedra, against ranks of their boundary matrices; hanging points.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "multimesh/algorithms/betti_numbers.hpp"
#include "multimesh/algorithms/tet_topology.hpp"
#include "oracle/homology.hpp"
#include "test/domain/box.hpp"

namespace multimesh::test {
namespace {

oracle::SimplexSet closure(const FacetList& facets) {
  std::set<oracle::Simplex> all;
  for (std::size_t f = 0; f < facets.size(); ++f) {
    const auto v = facets.facet(f);
    for (unsigned subset = 1; subset < 1U << v.size(); ++subset) {
      std::vector<int> corners;
      for (std::size_t i = 0; i < v.size(); ++i)
        if (subset >> i & 1U) corners.push_back(static_cast<int>(v[i]));
      std::sort(corners.begin(), corners.end());
      oracle::Simplex s;
      for (const int c : corners) s.v[static_cast<std::size_t>(s.n++)] = c;
      all.insert(s);
    }
  }
  return {all.begin(), all.end()};
}

void expect_same_numbers(const FacetList& facets) {
  const BettiNumbers ours = betti_numbers(facets);
  const oracle::Betti theirs = oracle::betti(closure(facets));
  EXPECT_EQ(static_cast<int>(ours.components), theirs[0]);
  EXPECT_EQ(static_cast<int>(ours.handles), theirs[1]);
}

/// Of a box of cubes, those for which `has` is true.
TaggedTetrahedra some_cubes(Index n, const std::function<bool(Index, Index, Index)>& has) {
  const TaggedTetrahedra all = box(n, n, n, [&](Index x, Index y, Index z) { return has(x, y, z); });
  TaggedTetrahedra some;
  some.points = all.points;
  for (std::size_t t = 0; t < all.tets.size(); ++t)
    if (all.regions[t])
      some.tets.corners.insert(some.tets.corners.end(), all.tets.facet(t).begin(), all.tets.facet(t).end());
  some.tets.vertices = all.tets.vertices;
  return some;
}

TEST(BettiNumbers, AreThoseOfTheBoundaryMatrices) {
  std::mt19937 random(1);
  for (int round = 0; round < 40; ++round) {
    const unsigned share = 3 + static_cast<unsigned>(random() % 6);
    expect_same_numbers(some_cubes(3, [&](Index, Index, Index) { return random() % 10 < share; }).tets);
    for (const int dimension : {1, 2, 3}) {
      FacetList soup{dimension, 9, {}};
      for (std::size_t f = 0; f < 4 + random() % 12; ++f) {
        std::array<Index, 9> v{0, 1, 2, 3, 4, 5, 6, 7, 8};
        std::shuffle(v.begin(), v.end(), random);
        soup.corners.insert(soup.corners.end(), v.begin(), v.begin() + dimension + 1);
      }
      expect_same_numbers(soup);
    }
  }
}

TEST(TetTopology, KnowsHandlesCavitiesAndPinches) {
  const auto ring =
      topology_of(some_cubes(3, [](Index x, Index y, Index z) { return z == 1 && !(x == 1 && y == 1); }));
  EXPECT_EQ(ring.handles, 1);
  EXPECT_EQ(ring.cavities, 0);
  EXPECT_EQ(ring.boundary_area, 2 * 8 + 12 + 4);
  const auto shell =
      topology_of(some_cubes(3, [](Index x, Index y, Index z) { return !(x == 1 && y == 1 && z == 1); }));
  EXPECT_EQ(shell.handles, 0);
  EXPECT_EQ(shell.cavities, 1);
  EXPECT_EQ(shell.boundary_components, 2U);
  EXPECT_NEAR(shell.volumes.at(0), 26, 1e-12);
  const auto by_an_edge =
      topology_of(some_cubes(2, [](Index x, Index y, Index z) { return x == y && z == 0; }));
  EXPECT_EQ(by_an_edge.components, 1U);
  EXPECT_EQ(by_an_edge.face_components, 2U);
  EXPECT_EQ(by_an_edge.pinched_edges, 1U);
  EXPECT_EQ(by_an_edge.euler_characteristic, 1);
}

// The cavity touches the outside in one point, whose link is an annulus.
TEST(TetTopology, CountsACavityThatTouchesTheOutside) {
  const TaggedTetrahedra tets = some_cubes(4, [](Index x, Index y, Index z) {
    return !(x == 1 && y == 1 && z == 1) && !(x == 0 && y == 0 && z == 0);
  });
  const TetTopology t = topology_of(tets);
  EXPECT_EQ(t.euler_characteristic, 2);
  EXPECT_EQ(t.cavities, 1);
  EXPECT_EQ(t.handles, 0);
  const TetDomain domain(tets);
  EXPECT_GT(domain.report().copied_vertices, 0U);
  EXPECT_EQ(differences(t, topology_of(domain.tagged()), 0), std::vector<std::string>{});
}

TEST(TetTopology, TellsWhatDiffers) {
  const auto whole = topology_of(box(2, 2, 2)),
             ring = topology_of(
                 some_cubes(3, [](Index x, Index y, Index z) { return z == 1 && !(x == 1 && y == 1); }));
  EXPECT_EQ(differences(whole, whole, 0), std::vector<std::string>{});
  std::string all;
  for (const std::string& s : differences(whole, ring, 0)) all += s + '\n';
  EXPECT_NE(all.find("handles: 0 before, 1 after"), std::string::npos) << all;
  EXPECT_NE(all.find("area of the boundary: 24 before"), std::string::npos) << all;
}

TEST(HangingPoints, AreFoundInEdgesAndFaces) {
  TaggedTetrahedra t;
  t.points = {{0, 0, 0},     {1, 0, 0},       {0, 1, 0},      {0, 0, 1},
              {0.5, 0.5, 0}, {0.25, 0.25, 0}, {0.3, 0.3, -1}, {1, 1, -1}};
  t.tets = {3, 8, {0, 1, 2, 3}};
  EXPECT_TRUE(hanging_points(t).empty());
  t.tets.corners.insert(t.tets.corners.end(), {4, 5, 6, 7});  // below: 4 in an edge, 5 in a face
  EXPECT_EQ(hanging_points(t), (std::vector<Index>{4, 5}));
}

}  // namespace
}  // namespace multimesh::test
