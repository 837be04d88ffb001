// SPDX-License-Identifier: BSD-3-Clause
// The tetrahedra of a periodic cell are improved below their torus.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh {
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

TEST(ImproveTile, GetsBetterBelowItsTorusAndStaysPeriodic) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    PeriodicDomain domain(crooked_tile(seed), test::along(true, true, true));
    ASSERT_EQ(domain.report().inverted_facets, 0U);
    const std::set<Triangle> sides = side_triangles(domain);
    const Embedding embedding = domain.embedding();
    const ImproveResult r = improve(embedding, domain.tile(), {.target_amips = 5});
    EXPECT_GT(r.before.max_amips, 20) << seed;
    EXPECT_LT(r.after.max_amips, r.before.max_amips / 2) << seed;
    EXPECT_LT(r.after.mean_amips, r.before.mean_amips) << seed;
    std::size_t done = 0;
    for (const OperationCount& c : r.operations) done += c.done;
    EXPECT_GT(done, 50U) << seed;

    EXPECT_EQ(count_inverted(domain), 0U) << seed;
    EXPECT_LT(domain.mismatch(), 1e-15) << seed;
    EXPECT_EQ(side_triangles(domain), sides) << seed;
    EXPECT_TRUE(validate(domain.tree()).empty()) << seed;
    const PeriodicDomain again(domain.tile_lists(), domain.gluing());
    EXPECT_EQ(again.report().euler, domain.report().euler) << seed;
    EXPECT_EQ(again.report().inverted_facets, 0U) << seed;
  }
}

// Only sides with several preimages are held by themselves.
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

TEST(ImproveTile, NeedsTetrahedra) {
  PeriodicDomain domain(test::square_tile(4, 4), test::along(true, true, false));
  const Embedding embedding = domain.embedding();
  EXPECT_THROW((void)improve(embedding, domain.tile()), UsageError);
}

}  // namespace
}  // namespace multimesh
