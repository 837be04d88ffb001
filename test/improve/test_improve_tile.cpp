// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a periodic cell are improved below their torus.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/tile_topology.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/validate.hpp"
#include "test/improve/random_operations.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh {

static void PrintTo(TileSides sides, std::ostream* out) {
  constexpr const char* names[] = {"Flat", "Free", "Frozen"};
  *out << names[static_cast<std::size_t>(sides)];
}

namespace {

bool is_in_the_hole(const PeriodicTile& tile, std::size_t t) {
  const auto corners = tile.facets.facet(t);
  return std::ranges::all_of(corners, [&](Index v) {
    return std::ranges::all_of(tile.points[v], [](double x) { return x > 0.39 && x < 0.61; });
  });
}

/// A cell with a hole in the middle, whose free vertices have gone astray.
PeriodicTile crooked_tile(unsigned seed) {
  constexpr Index n = 5;
  PeriodicTile tile = test::cube_tile(n);
  std::vector<Index> corners;
  for (std::size_t t = 0; t < tile.facets.size(); ++t)
    if (!is_in_the_hole(tile, t))
      for (const Index v : tile.facets.facet(t)) corners.push_back(v);
  tile.facets.corners = corners;
  std::vector<std::vector<std::size_t>> around(tile.points.size());
  for (std::size_t t = 0; t < tile.facets.size(); ++t)
    for (const Index v : tile.facets.facet(t)) around[v].push_back(t);
  const auto is_positive = [&](std::size_t t) {
    const auto v = tile.facets.facet(t);
    const auto p = [&](std::size_t i) { return tile.points[v[i]].data(); };
    return orient3d(p(0), p(1), p(2), p(3)) > 0;
  };
  std::mt19937 random(seed);
  const auto step = [&] { return (static_cast<double>(random()) / 0x1p31 - 1) * 0.9 / n; };
  for (Index v = 0; v < tile.points.size(); ++v) {
    auto& p = tile.points[v];
    const auto is_free = [](double x) { return x > 0.1 && x < 0.9; };
    const auto is_at_hole = [](double x) { return x > 0.39 && x < 0.61; };
    if (!std::ranges::all_of(p, is_free) || std::ranges::all_of(p, is_at_hole)) continue;
    const auto old = p;
    for (int tries = 0; tries < 20; ++tries) {
      p = {old[0] + step(), old[1] + step(), old[2] + step()};
      if (std::ranges::all_of(around[v], is_positive)) break;
      p = old;
    }
  }
  return tile;
}

using Place = std::array<double, 3>;
using Triangle = std::set<Place>;

/// The faces that are glued, by their places.
std::set<Triangle> side_triangles(const PeriodicDomain& domain) {
  const PeriodicTile tile = domain.tile_lists();
  std::set<Triangle> all;
  for (const PeriodicSide& side : domain.sides())
    for (const FacetList* faces : {&side.master, &side.slave})
      for (std::size_t f = 0; f < faces->size(); ++f) {
        Triangle t;
        for (const Index v : faces->facet(f)) t.insert(tile.points[v]);
        all.insert(t);
      }
  return all;
}

std::size_t count_inverted(const PeriodicDomain& domain) {
  const PeriodicTile tile = domain.tile_lists();
  std::size_t n = 0;
  for (std::size_t t = 0; t < tile.facets.size(); ++t) {
    const auto v = tile.facets.facet(t);
    const auto p = [&](std::size_t i) { return tile.points[v[i]].data(); };
    n += orient3d(p(0), p(1), p(2), p(3)) <= 0;
  }
  return n;
}

/// Something is wrong with a tile whose corners are moved; empty: nothing.
std::string fault(const PeriodicDomain& domain) {
  if (count_inverted(domain) > 0) return "inverted";
  if (!(domain.mismatch() < 1e-15)) return "copies lie apart";
  const auto problems = validate(domain.tree());
  if (!problems.empty()) return problems.front();
  const PeriodicDomain again(domain.tile_lists(), domain.gluing());
  if (again.report().euler != domain.report().euler) return "another topology";
  return again.report().inverted_facets > 0 ? "inverted when glued again" : "";
}

std::size_t count_done(const ImproveResult& r) {
  std::size_t done = 0;
  for (const OperationCount& c : r.operations) done += c.done;
  return done;
}

class ImproveTileSides : public testing::TestWithParam<TileSides> {};

TEST_P(ImproveTileSides, GetsBetterBelowItsTorusAndStaysPeriodic) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    PeriodicDomain domain(crooked_tile(seed), test::along(true, true, true));
    ASSERT_EQ(domain.report().inverted_facets, 0U);
    const std::set<Triangle> sides = side_triangles(domain);
    const Embedding embedding = domain.embedding(GetParam());
    const ImproveResult r = improve(embedding, domain.tile(), {.target_amips = 5});
    EXPECT_GT(r.before.max_amips, 20) << seed;
    EXPECT_LT(r.after.max_amips, r.before.max_amips / 2) << seed;
    EXPECT_LT(r.after.mean_amips, r.before.mean_amips) << seed;
    EXPECT_GT(count_done(r), 50U) << seed;
    EXPECT_EQ(fault(domain), "") << seed;
    const auto points = domain.tile_lists().points;  // in all three, the tile does not drift
    for (const Place& corner : {Place{0, 0, 0}, {1, 1, 1}}) EXPECT_TRUE(std::ranges::count(points, corner));

    const std::set<Triangle> now = side_triangles(domain);
    const auto in_box = [](double x) { return x == 0 || x == 1; };
    const bool flat = std::ranges::all_of(now, [&](const Triangle& t) {
      const auto in_side = [&](std::size_t i) {
        return std::ranges::all_of(t,
                                   [&](const Place& p) { return in_box(p[i]) && p[i] == (*t.begin())[i]; });
      };
      return in_side(0) || in_side(1) || in_side(2);
    });
    EXPECT_EQ(flat, GetParam() != TileSides::free) << seed;
    EXPECT_EQ(now == sides, GetParam() == TileSides::frozen) << seed;
  }
}

std::string name_of(const testing::TestParamInfo<TileSides>& sides) {
  return testing::PrintToString(sides.param);
}
INSTANTIATE_TEST_SUITE_P(All, ImproveTileSides,
                         testing::Values(TileSides::flat, TileSides::free, TileSides::frozen), name_of);

// The corner of the box has eight copies, and an edge of it four: they are vertices and edges like others.
TEST(ImproveTile, SplitsAndMovesWhatHasCopies) {
  PeriodicTile tile = test::cube_tile(3);
  for (auto& p : tile.points)  // one layer of the tile is thin
    p[2] = p[2] < 0.4 ? 0.06 * p[2] : p[2] < 0.7 ? p[2] - 0.31 + 0.05 : p[2];
  PeriodicDomain domain(tile, test::along(true, true, true));
  const Embedding embedding = domain.embedding(TileSides::free);
  const ImproveResult r = improve(embedding, domain.tile(), {.target_amips = 5});
  EXPECT_LT(r.after.max_amips, r.before.max_amips / 2);
  EXPECT_EQ(fault(domain), "");
  const std::size_t vertices = domain.tile_lists().points.size();
  EXPECT_GT(split_long_edges(embedding, domain.tile(), 0.2), 0U);
  EXPECT_GT(domain.tile_lists().points.size(), vertices);
  EXPECT_EQ(fault(domain), "");
}

// The sides are no surface of the material.
TEST(ImproveTile, KeepsTheHoleAsASetOfPoints) {
  PeriodicDomain domain(crooked_tile(4), test::along(true, true, true));
  const Embedding embedding = domain.embedding();
  const auto volume = [&] {
    double sum = 0;
    const Mesh& mesh = domain.tree().mesh(domain.tile());
    for (Index t = 0; t < mesh.capacity(3); ++t)
      if (mesh.is_live(3, t)) sum += signed_measure(domain, t, {});
    return sum;
  };
  EXPECT_NEAR(volume(), 1 - 1.0 / 125, 1e-12);
  const std::size_t splits = split_long_edges(embedding, domain.tile(), 0.3);
  (void)improve(embedding, domain.tile());
  EXPECT_GT(splits, 0U);
  EXPECT_NEAR(volume(), 1 - 1.0 / 125, 1e-12);
}

/// A cube whose copies are lattice vectors apart only up to rounding, with a block of region 2 at one side.
PeriodicTile tile_with_block() {
  PeriodicTile tile = test::cube_tile(4);
  for (std::size_t t = 0; t < tile.facets.size(); ++t) {
    const auto corners = tile.facets.facet(t);
    tile.regions.push_back(std::ranges::all_of(corners,
                                               [&](Index v) {
                                                 const auto& p = tile.points[v];
                                                 return p[0] < 0.6 && p[1] > 0.2 && p[2] > 0.2;
                                               })
                               ? 2
                               : 1);
  }
  for (auto& p : tile.points) p = {0.1 + p[0] / 3 + p[1] / 7, p[1] / 1.7, p[2] / 0.9 - p[0] / 11};
  return tile;
}

// Also where an interface lies in a side, or ends there.
TEST(ImproveTile, InAStormKeepsRegionsAndOrientation) {
  for (const TileSides sides : {TileSides::flat, TileSides::free}) {
    PeriodicOptions options = test::along(true, true, true);
    options.periods = {{{1. / 3, 0, -1. / 11}, {1. / 7, 1 / 1.7, 0}, {0, 0, 1 / 0.9}}};
    options.interfaces = true;
    PeriodicDomain domain(tile_with_block(), options);
    ASSERT_TRUE(domain.listed(2));
    const auto volumes = [&] {
      std::array<double, 3> sum{};
      const Mesh& mesh = domain.tree().mesh(domain.tile());
      for (Index t = 0; t < mesh.capacity(3); ++t)
        if (mesh.is_live(3, t))
          sum[static_cast<std::size_t>(domain.region(t))] += signed_measure(domain, t, {});
      return sum;
    };
    const auto before = volumes();
    const Embedding embedding = domain.embedding(sides);
    improvement::Workspace work(embedding, domain.tile(), {});
    improvement::Counts counts{};
    improvement::Refusals refusals(1);
    improvement::Candidates candidates(work, counts, refusals);
    std::mt19937 random(17);
    std::array<std::size_t, improvement::n_kinds> done{};
    for (int i = 0; i < 6000; ++i) {
      const improvement::Candidate c = test::random_candidate(work, candidates, random);
      if (!c) continue;
      const bool has_copies = work.is_copied(work.mesh().vertex(c.dart));
      if (test::do_it(work, c) != no_dart) done[static_cast<std::size_t>(c.kind)] += has_copies;
      if (i % 1000 == 0) {
        ASSERT_EQ(fault(domain), "");
      }
    }
    EXPECT_EQ(fault(domain), "");
    for (std::size_t k = 1; k < 3; ++k) EXPECT_NEAR(volumes()[k], before[k], 1e-12 * before[k]);
    for (const improvement::Kind k :
         {improvement::Kind::split, improvement::Kind::collapse, improvement::Kind::smoothing})
      EXPECT_GT(done[static_cast<std::size_t>(k)], 10U);
  }
}

TEST(ImproveTile, NeedsTetrahedra) {
  PeriodicDomain domain(test::square_tile(4, 4), test::along(true, true, false));
  const Embedding embedding = domain.embedding();
  EXPECT_THROW((void)improve(embedding, domain.tile()), UsageError);
}

std::array<std::size_t, 4> count_live(const Mesh& mesh) {
  std::array<std::size_t, 4> n{};
  for (int k = 0; k <= mesh.dimension(); ++k)
    for (Index s = 0; s < mesh.capacity(k); ++s)
      n[static_cast<std::size_t>(k)] += mesh.is_live(k, s) && mesh.dart_of(k, s) != no_dart;
  return n;
}

TEST(TileTopology, ReadFromListsIsThatOfTheGluedMesh) {
  const auto everywhere = test::along(true, true, true);
  for (const auto& [tile, options] : {std::pair{test::cube_tile(4), everywhere},
                                      {crooked_tile(1), everywhere},
                                      {test::cube_tile(4), test::along(false, true, true)},
                                      {test::square_tile(4, 5), everywhere}}) {
    PeriodicDomain domain(tile, options);
    for (const bool changed : {false, true}) {
      if (changed && tile.facets.dimension == 3) {
        ImproveOptions improve_options;
        improve_options.target_amips = 3.5;
        improve_options.max_passes = 2;
        improve(domain.embedding(), domain.tile(), improve_options);
      }
      const TileTopology t = topology_of(domain);
      EXPECT_EQ(t.simplices, count_live(domain.tree().mesh(NodeId::root)));
      EXPECT_EQ(t.improper, 0U);
      if (changed) continue;
      EXPECT_EQ(t.simplices, domain.report().simplices);
      EXPECT_EQ(t.euler, domain.report().euler);
      EXPECT_EQ(t.with_copies, domain.report().with_copies);
    }
  }
}

}  // namespace
}  // namespace multimesh
