// SPDX-License-Identifier: BSD-3-Clause
// Cutting in dimension 3: tetrahedra stay, and the result is a manifold mesh that TetMesh accepts.
#include <gtest/gtest.h>

#include <random>

#include "multimesh/mesh.hpp"
#include "multimesh/tet/tet_mesh.hpp"
#include "test/domain/box.hpp"

namespace multimesh::test {
namespace {

/// The tetrahedra of some cubes of a box.
FacetList cubes(Index nx, Index ny, Index nz, const std::function<bool(Index, Index, Index)>& has) {
  const TaggedTetrahedra all = box(nx, ny, nz, [&](Index x, Index y, Index z) { return has(x, y, z); });
  FacetList list{3, all.tets.vertices, {}};
  for (std::size_t t = 0; t < all.tets.size(); ++t)
    if (all.regions[t])
      list.corners.insert(list.corners.end(), all.tets.facet(t).begin(), all.tets.facet(t).end());
  return list;
}

/// Everything that holds of any cut. \return copies made of vertices
std::size_t expect_cut(const FacetList& list) {
  const Cut c = cut(list);
  EXPECT_EQ(c.facets.size(), list.size());
  for (std::size_t t = 0; t < list.size(); ++t) {
    std::array<Index, 4> was{}, is{};
    for (std::size_t i = 0; i < 4; ++i) was[i] = list.facet(t)[i], is[i] = c.source[c.facets.facet(t)[i]];
    if (c.reversed[t]) std::swap(is[0], is[1]);
    EXPECT_EQ(is, was) << "tetrahedron " << t;
  }
  const tet::TetMesh mesh(c.facets);
  std::vector<std::string> problems;
  mesh.check(problems);
  for (int k = 1; k <= 3; ++k) check_simplices_differ(mesh, k, problems);
  EXPECT_EQ(problems, std::vector<std::string>{});
  std::vector<Index> used = c.source;
  std::sort(used.begin(), used.end());
  return used.size() - static_cast<std::size_t>(std::unique(used.begin(), used.end()) - used.begin());
}

TEST(CutTetrahedra, LeavesManifoldsWhole) {
  EXPECT_EQ(expect_cut(cubes(2, 2, 2, [](Index, Index, Index) { return true; })), 0U);
  EXPECT_EQ(
      expect_cut(cubes(3, 3, 3, [](Index x, Index y, Index z) { return !(x == 1 && y == 1 && z == 1); })), 0U)
      << "a box with a cavity";
  EXPECT_EQ(expect_cut(cubes(3, 3, 1, [](Index x, Index y, Index) { return !(x == 1 && y == 1); })), 0U)
      << "a ring";
  EXPECT_EQ(expect_cut({3, 4, {0, 1, 2, 3}}), 0U);
}

TEST(CutTetrahedra, PartsAtASharedPoint) {
  EXPECT_EQ(expect_cut(cubes(2, 2, 2, [](Index x, Index y, Index z) { return x == y && y == z; })), 1U);
}

TEST(CutTetrahedra, PartsAtASharedEdge) {
  EXPECT_EQ(expect_cut(cubes(2, 2, 1, [](Index x, Index y, Index) { return x == y; })), 2U);
}

TEST(CutTetrahedra, PartsAnEdgeWhoseEndsHangTogetherElsewhere) {
  // Two diagonal cubes below a whole layer: the edge between them is pinched, its upper end is not.
  const FacetList list = cubes(2, 2, 2, [](Index x, Index y, Index z) { return z == 1 || x == y; });
  EXPECT_GT(expect_cut(list), 0U);
}

TEST(CutTetrahedra, PartsAVertexWhoseLinkIsAnAnnulus) {
  // Four cubes around the middle edge of the lower layer, and all but two diagonal ones above, leave a link
  // with two holes; the tunnel and the outside touch in the middle.
  const FacetList list = cubes(2, 2, 2, [](Index x, Index y, Index z) {
    return !((x == 0 && y == 0 && z == 0) || (x == 1 && y == 1 && z == 1));
  });
  EXPECT_GT(expect_cut(list), 0U);
}

TEST(CutTetrahedra, PartsThreeTetrahedraOnAFace) {
  EXPECT_GT(expect_cut({3, 6, {0, 1, 2, 3, 0, 2, 1, 4, 0, 1, 2, 5}}), 0U);
}

TEST(CutTetrahedra, PartsRepeatedTetrahedra) {
  EXPECT_GT(expect_cut({3, 4, {0, 1, 2, 3, 0, 1, 2, 3}}), 0U);
  EXPECT_GT(expect_cut({3, 4, {0, 1, 2, 3, 1, 0, 2, 3}}), 0U);
}

TEST(CutTetrahedra, Orients) {
  FacetList list = cubes(2, 2, 2, [](Index, Index, Index) { return true; });
  std::mt19937 random(1);
  for (std::size_t t = 0; t < list.size(); ++t)
    if (random() % 2) std::swap(list.corners[4 * t + 2], list.corners[4 * t + 3]);
  EXPECT_EQ(expect_cut(list), 0U);
}

class CutRandomTetrahedra : public testing::TestWithParam<unsigned> {};

TEST_P(CutRandomTetrahedra, MakesThemManifold) {
  std::mt19937 random(GetParam());
  const auto keep = [&](Index, Index, Index) { return random() % 2 == 0; };
  if (const FacetList list = cubes(3, 3, 3, keep); list.size() > 0) expect_cut(list);
  // Tetrahedra at random, of few points.
  FacetList soup{3, 9, {}};
  for (int t = 0; t < 14; ++t) {
    std::array<Index, 9> v{0, 1, 2, 3, 4, 5, 6, 7, 8};
    std::shuffle(v.begin(), v.end(), random);
    soup.corners.insert(soup.corners.end(), v.begin(), v.begin() + 4);
  }
  expect_cut(soup);
}

INSTANTIATE_TEST_SUITE_P(Seeds, CutRandomTetrahedra, testing::Range(0U, 60U));

TEST(TetMeshInput, RefusesWhatIsNotManifold) {
  const auto refused = [](const FacetList& list, const char* part_of_message) {
    try {
      const tet::TetMesh mesh(list);
      ADD_FAILURE() << "taken";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(part_of_message), std::string::npos) << e.what();
    }
  };
  refused({3, 6, {0, 1, 2, 3, 0, 2, 1, 4, 0, 1, 2, 5}}, "tetrahedra 0, 1 and 2 share the face 0-1-2");
  refused({3, 5, {0, 1, 2, 3, 0, 1, 2, 4}}, "oriented against each other");
  refused({3, 4, {0, 1, 2, 3, 0, 2, 1, 3}}, "share two faces");
  refused({3, 4, {0, 1, 2, 2}}, "twice");
  refused({3, 3, {0, 1, 2, 3}}, "names vertex 3 of 3");
  refused({3, 7, {0, 1, 2, 3, 0, 4, 5, 6}}, "vertex 0 joins parts");
  EXPECT_THROW(tet::TetMesh({2, 3, {0, 1, 2}}), UsageError);
}

}  // namespace
}  // namespace multimesh::test
