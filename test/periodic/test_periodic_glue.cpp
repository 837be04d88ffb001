// SPDX-License-Identifier: BSD-3-Clause
// What the glued tile is: numbers of simplices, copies, legal collapses, homology.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "multimesh/cut.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/betti.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

using Numbers = std::array<std::size_t, 4>;
using Betti = std::vector<long>;

void expect_sound(const PeriodicDomain& domain) {
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  EXPECT_LE(domain.mismatch(), 1e-15);
  EXPECT_EQ(domain.report().inverted_facets, 0U);
  EXPECT_EQ(domain.report().cut_vertices, 0U);
  EXPECT_EQ(domain.report().cut_root_vertices, 0U);
}

std::size_t edges_that_meet_link_condition(const PeriodicDomain& domain) {
  const Mesh& root = domain.tree().mesh(NodeId::root);
  std::size_t n = 0;
  for (Index e = 0; e < root.capacity(1); ++e)
    n += root.is_live(1, e) && root.link_condition(root.dart_of(1, e));
  return n;
}

// A collapse is refused just where both ends lie on more sides than the edge: it would glue two sides.
void expect_refused_only_between_sides(PeriodicDomain& domain) {
  Propagation operations(domain.tree());
  const Mesh& root = domain.tree().mesh(NodeId::root);
  const auto copies = [&](Dart d, int k) {
    DartBuffer found;
    domain.tree().to_child(domain.tile(), d, k, found);
    return found.size();
  };
  for (Index e = 0; e < root.capacity(1); ++e) {
    if (!root.is_live(1, e)) continue;
    const Dart d = root.dart_of(1, e), back = root.reorder(d, exchange_ends);
    const bool between = copies(d, 0) > copies(d, 1) && copies(back, 0) > copies(d, 1);
    EXPECT_EQ(operations.judge(NodeId::root, d).refusal.refused(), between);
  }
}

TEST(PeriodicSquare, OneAndTwoSquaresAreRefusedNamingThePeriodAndAnEdge) {
  const std::string one = refusal(square_tile(1, 1), along(true, true, false));
  EXPECT_NE(one.find("only 1 edge (0-2) along x"), std::string::npos) << one;
  EXPECT_NE(one.find("only 1 edge (2-3) along y"), std::string::npos) << one;
  const std::string two = refusal(square_tile(2, 2), along(true, true, false));
  EXPECT_NE(two.find("along x; at least 3 are needed"), std::string::npos) << two;
  EXPECT_NE(two.find("only 2 edges ("), std::string::npos) << two;
  const std::string mixed = refusal(square_tile(4, 2), along(true, true, false));
  EXPECT_EQ(mixed.find("along x"), std::string::npos) << mixed;
  EXPECT_NE(mixed.find("along y"), std::string::npos) << mixed;
}

TEST(PeriodicSquare, ThreeSquaresAreATorusInWhichNoCollapseIsLegal) {
  PeriodicDomain domain(square_tile(3, 3), along(true, true, false));
  EXPECT_EQ(domain.report().simplices, (Numbers{9, 27, 18, 0}));
  EXPECT_EQ(domain.report().euler, 0);
  EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), (Betti{1, 2, 1}));
  EXPECT_EQ(legal_edges(domain), 0U);
  expect_sound(domain);
}

TEST(PeriodicSquare, FourSquaresAreATorusInWhichAllCollapsesAreLegalThatJoinNoSides) {
  PeriodicDomain domain(square_tile(4, 4), along(true, true, false));
  EXPECT_EQ(domain.report().simplices, (Numbers{16, 48, 32, 0}));
  EXPECT_EQ(domain.report().with_copies, (std::vector<std::size_t>{0, 9, 6, 0, 1}));
  EXPECT_EQ(edges_that_meet_link_condition(domain), 48U);
  EXPECT_EQ(legal_edges(domain), 46U);  // one cuts off a corner at two places
  expect_refused_only_between_sides(domain);
  expect_sound(domain);
}

TEST(PeriodicSquare, OnePeriodMakesACylinder) {
  PeriodicDomain domain(square_tile(4, 2), along(true, false, false));
  EXPECT_EQ(domain.report().simplices, (Numbers{12, 28, 16, 0}));
  EXPECT_EQ(domain.report().with_copies, (std::vector<std::size_t>{0, 9, 3}));
  EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), (Betti{1, 1, 0}));
  expect_sound(domain);
}

TEST(PeriodicCube, OneAndTwoCubesAreRefused) {
  for (const Index n : {1U, 2U}) {
    const std::string why = refusal(cube_tile(n), along(true, true, true));
    for (const char* axis : {" along x;", " along y;", " along z;"})
      EXPECT_NE(why.find(axis), std::string::npos) << why;
  }
}

TEST(PeriodicCube, ThreeCubesAreATorusInWhichNoCollapseIsLegal) {
  PeriodicDomain domain(cube_tile(3), along(true, true, true));
  EXPECT_EQ(domain.report().simplices, (Numbers{27, 189, 324, 162}));
  EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), (Betti{1, 3, 3, 1}));
  EXPECT_EQ(legal_edges(domain), 0U);
  expect_sound(domain);
}

TEST(PeriodicCube, FourCubesAreATorusInWhichAllCollapsesAreLegalThatJoinNoSides) {
  PeriodicDomain domain(cube_tile(4), along(true, true, true));
  EXPECT_EQ(domain.report().simplices, (Numbers{64, 448, 768, 384}));
  EXPECT_EQ(domain.report().with_copies, (std::vector<std::size_t>{0, 27, 27, 0, 9, 0, 0, 0, 1}));
  EXPECT_EQ(domain.report().euler, 0);
  EXPECT_EQ(edges_that_meet_link_condition(domain), 448U);
  expect_refused_only_between_sides(domain);
  expect_sound(domain);
}

TEST(PeriodicCube, OneOrTwoPeriods) {
  PeriodicDomain one(cube_tile(3), along(false, false, true)), two(cube_tile(3), along(true, true, false));
  EXPECT_EQ(betti(one.tree().mesh(NodeId::root)), (Betti{1, 1, 0, 0}));  // solid torus
  EXPECT_EQ(betti(two.tree().mesh(NodeId::root)), (Betti{1, 2, 1, 0}));  // torus x interval
  EXPECT_EQ(two.report().with_copies, (std::vector<std::size_t>{0, 16, 16, 0, 4}));
  expect_sound(one), expect_sound(two);
}

TEST(PeriodicTileMesh, KeepsTheInputsNumbersAndDiffersByItsOffsets) {
  const PeriodicTile tile = cube_tile(3);
  PeriodicDomain domain(tile, along(true, true, true));
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  ASSERT_EQ(mesh.capacity(0), tile.points.size());
  for (Index v = 0; v < tile.points.size(); ++v) {
    EXPECT_LE((domain.positions()[v] - Vec3(tile.points[v])).norm(), 1e-15);
    EXPECT_EQ(domain.input_vertices()[v], v);
    const Dart image = domain.tree().to_parent(domain.tile(), mesh.dart_of(0, v));
    DartBuffer copies;
    domain.tree().to_child(domain.tile(), image, 0, copies);
    for (const Dart c : copies)
      EXPECT_LE((domain.common_place(mesh.vertex(c)) - domain.common_place(v)).norm(), 1e-15);
  }
  const PeriodicTile back = domain.tile_lists();
  EXPECT_EQ(back.facets.size(), tile.facets.size());
  EXPECT_EQ(back.points.size(), tile.points.size());
}

TEST(PeriodicTileMesh, SheetsInOtherPlanesAndTurnedFacetsAreOrientedAlike) {
  PeriodicTile tile = square_tile(4, 4);
  for (auto& p : tile.points) p = {p[1], 0.25 * p[0] * (1 - p[0]), p[0]};  // over the xz plane, bent
  for (std::size_t f = 0; f < tile.facets.size(); f += 3)
    std::swap(tile.facets.corners[3 * f], tile.facets.corners[3 * f + 1]);
  PeriodicDomain domain(tile, along(true, false, true));
  EXPECT_EQ(domain.report().euler, 0);
  EXPECT_GT(domain.report().reversed_facets, 0U);
  expect_sound(domain);
}

TEST(PeriodicSurface, IsTheBoundaryOfTheMaterialWithoutTheSides) {
  PeriodicDomain closed(square_tile(4, 4), along(true, true, false));
  EXPECT_FALSE(closed.add_surface());
  const auto sides = closed.add_cuts();
  ASSERT_TRUE(sides);
  EXPECT_EQ(closed.tree().mesh(*sides).capacity(1), 16U);

  PeriodicDomain slab(cube_tile(3), along(true, true, false));
  const auto surface = slab.add_surface(), cuts = slab.add_cuts();
  ASSERT_TRUE(surface && cuts);
  EXPECT_EQ(slab.tree().mesh(*surface).capacity(2), 2 * 18U);
  EXPECT_EQ(betti(slab.tree().mesh(*surface)), (Betti{2, 0, 0}));
  EXPECT_EQ(slab.tree().mesh(*cuts).capacity(2), 4 * 18U);
  EXPECT_EQ(betti(slab.tree().mesh(*cuts)), (Betti{1, 1, 0}));  // four walls of a room
  EXPECT_EQ(validate(slab.tree()), std::vector<std::string>{});
}

/// The facets of a tile whose centre passes the test.
PeriodicTile part(PeriodicTile tile, const std::function<bool(double x, double y)>& keep) {
  FacetList kept{2, tile.facets.vertices, {}};
  for (std::size_t f = 0; f < tile.facets.size(); ++f) {
    const auto v = tile.facets.facet(f);
    double x = 0, y = 0;
    for (const Index i : v) x += tile.points[i][0] / 3, y += tile.points[i][1] / 3;
    if (keep(x, y)) kept.corners.insert(kept.corners.end(), v.begin(), v.end());
  }
  tile.facets = kept;
  return tile;
}

TEST(PeriodicSquare, ATileWithAHoleHasTheHolesBoundary) {
  const PeriodicTile tile = part(square_tile(6, 6), [](double x, double y) {
    return std::abs(x - 0.5) > 1.0 / 6 || std::abs(y - 0.5) > 1.0 / 6;
  });
  PeriodicDomain domain(tile, along(true, true, false));
  EXPECT_EQ(domain.report().euler, -1);
  EXPECT_EQ(betti(domain.tree().mesh(NodeId::root)), (Betti{1, 2, 0}));
  const auto hole = domain.add_surface();
  ASSERT_TRUE(hole);
  EXPECT_EQ(domain.tree().mesh(*hole).capacity(1), 8U);
  EXPECT_EQ(betti(domain.tree().mesh(*hole)), (Betti{1, 1}));
}

TEST(PeriodicNotManifold, ATileIsCutWhereItsPartsTouchInAPoint) {
  // A frame, and two squares inside it that touch.
  const PeriodicTile tile = part(square_tile(6, 6), [](double x, double y) {
    const int i = static_cast<int>(6 * x), j = static_cast<int>(6 * y);
    return i % 5 == 0 || j % 5 == 0 || (i == j && (i == 2 || i == 3));
  });
  PeriodicDomain domain(tile, along(true, true, false));
  EXPECT_EQ(domain.report().cut_vertices, 1U);
  EXPECT_EQ(domain.report().cut_root_vertices, 1U);
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  EXPECT_LE(domain.mismatch(), 1e-15);
  Propagation operations(domain.tree());
  domain.attach(operations);
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  std::size_t locked = 0;
  for (Index v = 0; v < mesh.capacity(0); ++v) {
    EXPECT_EQ(domain.positions()[v], Vec3(tile.points[domain.input_vertices()[v]]));
    const Outcome moved = domain.move(operations, domain.tile(), mesh.dart_of(0, v), {0, 0, 0});
    locked += moved.refusal.check == Check::locked;
  }
  EXPECT_EQ(locked, 2U);
}

TEST(PeriodicNotManifold, ARootIsCutWhereCopiesTouchInAPoint) {
  const PeriodicTile tile = part(
      square_tile(4, 4), [](double x, double y) { return (x < 0.5 && y < 0.5) || (x > 0.5 && y > 0.5); });
  PeriodicOptions options = along(true, true, false);
  options.pairs = {{0, 24}};  // opposite corners of the box
  PeriodicDomain domain(tile, options);
  EXPECT_EQ(domain.report().cut_vertices, 1U);       // in the middle
  EXPECT_EQ(domain.report().cut_root_vertices, 2U);  // and there
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
}

TEST(PeriodicNotManifold, TilesWithHolesAnywhereAreCutLikeTilesWithoutPeriods) {
  std::mt19937 random(1);
  std::array<int, 2> seen{};  // manifold ones, others
  for (int round = 0; round < 400; ++round) {
    PeriodicTile tile = cube_tile(4);
    std::vector<Index> corners;
    const unsigned holes = round % 2 == 0 ? 3 : 60;  // of 384 tetrahedra
    for (std::size_t t = 0; t < tile.facets.size(); ++t)
      if (random() % 384 >= holes)
        for (const Index v : tile.facets.facet(t)) corners.push_back(v);
    tile.facets.corners = corners;
    if (!refusal(tile, along(true, true, true)).empty()) continue;
    const PeriodicDomain domain(tile, along(true, true, true));
    std::ranges::sort(corners);
    const auto used = std::unique(corners.begin(), corners.end()) - corners.begin();
    const std::size_t copies = cut(tile.facets).source.size() - static_cast<std::size_t>(used);
    EXPECT_EQ(domain.report().cut_vertices, copies);
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    ++seen[copies > 0 ? 1 : 0];
  }
  EXPECT_GE(seen[0], 20);
  EXPECT_GE(seen[1], 20);
}

TEST(PeriodicNotManifold, TilesThatOverlapTheirCopiesAreRefused) {
  PeriodicTile tile = square_tile(4, 4);
  PeriodicOptions options = along(true, false, false);
  options.periods = {{{0.75, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_NE(refusal(tile, options).find("lie at the same place"), std::string::npos)
      << refusal(tile, options);
  for (std::size_t f = 24; f < 32; f += 2) {  // the last column gets the other diagonals
    Index* c = tile.facets.corners.data() + 3 * f;
    const std::array<Index, 4> q{c[0], c[1], c[2], c[5]};
    const std::array<Index, 6> other{q[0], q[1], q[3], q[1], q[2], q[3]};
    std::copy(other.begin(), other.end(), c);
  }
  EXPECT_NE(refusal(tile, options).find("more than two facets meet"), std::string::npos)
      << refusal(tile, options);
}

}  // namespace
}  // namespace multimesh::test
