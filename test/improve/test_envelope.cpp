// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that move in envelopes.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "multimesh/algorithms/improve.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/geometry/envelope.hpp"
#include "multimesh/validate.hpp"
#include "test/improve/made_domain.hpp"
#include "test/improve/random_operations.hpp"
#include "test/improve/surface_distance.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh {
namespace {

using test::PlainTriangle;
using test::sampled_distance;

constexpr double rounding = 1 + 1e-9;

double random_in(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 0x1p32);
}

multimesh::Vec3 random_point(std::mt19937& random, double size) {
  return {random_in(random, -size, size), random_in(random, -size, size), random_in(random, -size, size)};
}

/// A bumpy sheet of 2 n^2 triangles over the unit square.
std::vector<spatial::Triangle> bumpy(int n, double height, std::mt19937& random) {
  std::vector<multimesh::Vec3> p;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) p.push_back({1.0 * i / n, 1.0 * j / n, random_in(random, 0, height)});
  std::vector<spatial::Triangle> all;
  const auto at = [&](int i, int j) { return p[static_cast<std::size_t>(i * (n + 1) + j)]; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      all.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      all.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return all;
}

std::vector<PlainTriangle> plain(const std::vector<spatial::Triangle>& triangles) {
  std::vector<PlainTriangle> all;
  for (const spatial::Triangle& t : triangles) all.push_back({t[0], t[1], t[2]});
  return all;
}

TEST(Envelope, AcceptsOnlyWhatIsInside) {
  std::mt19937 random(3);
  std::size_t accepted = 0;
  for (int i = 0; i < 300; ++i) {
    const auto surface = bumpy(4, random_in(random, 0, 0.2), random);
    const double distance = random_in(random, 0.01, 0.1);
    const spatial::Envelope envelope(surface, distance);
    for (int j = 0; j < 20; ++j) {
      const spatial::Triangle& near = surface[random() % surface.size()];
      const double size = random_in(random, 0, 0.3);
      spatial::Triangle t;
      for (multimesh::Vec3& p : t) {
        p = near[0] + random_point(random, size);
        if (random() % 2 == 0) p = envelope.closest(p) + random_point(random, distance);
      }
      if (!envelope.contains(t)) continue;
      ++accepted;
      EXPECT_LE(sampled_distance(plain({t}), plain(surface), 12), distance * rounding);
    }
  }
  EXPECT_GT(accepted, 300U);
}

TEST(Envelope, AcceptsWhatIsClearlyInside) {
  std::mt19937 random(4);
  for (int i = 0; i < 200; ++i) {
    const auto surface = bumpy(4, 0, random);  // plane: a triangle may lie over many of them
    const double distance = random_in(random, 0.02, 0.1);
    const spatial::Envelope envelope(surface, distance);
    spatial::Triangle t;
    for (multimesh::Vec3& p : t)
      p = {random_in(random, 0, 1), random_in(random, 0, 1), random_in(random, -0.9, 0.9) * distance};
    EXPECT_TRUE(envelope.contains(t));
    t[0][2] = 1.01 * distance;
    EXPECT_FALSE(envelope.contains(t));
  }
}

TEST(Envelope, FindsTheClosestPoint) {
  std::mt19937 random(5);
  const auto surface = bumpy(5, 0.3, random);
  const spatial::Envelope envelope(surface, 0.1);
  for (int i = 0; i < 200; ++i) {
    const multimesh::Vec3 p = random_point(random, 2);
    double least = 1e300;
    for (const PlainTriangle& t : plain(surface)) least = std::min(least, test::distance(p, t));
    EXPECT_NEAR((envelope.closest(p) - p).norm(), least, 1e-12);
  }
}

// --- inside tetrahedra ---------------------------------------------------------------------------------

/// The triangles of a mesh of a tree, at the places of another.
std::vector<PlainTriangle> triangles_of(const MultiMesh& tree, NodeId n, NodeId with_places,
                                        const std::vector<multimesh::Vec3>& places) {
  const Mesh& mesh = tree.mesh(n);
  std::vector<PlainTriangle> all;
  DartBuffer images;
  for (Index f = 0; f < mesh.capacity(2); ++f) {
    if (!mesh.is_live(2, f)) continue;
    images.clear();
    tree.map(n, mesh.dart_of(2, f), 2, with_places, MultiMesh::Via::root, images);
    Index v[4];
    tree.mesh(with_places).vertices(images.front(), v);
    all.push_back({places[v[0]], places[v[1]], places[v[2]]});
  }
  return all;
}

/// With all its neighbours in the lattice of the integers.
std::vector<PlainTriangle> repeated(const std::vector<PlainTriangle>& triangles) {
  std::vector<PlainTriangle> all;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        for (PlainTriangle t : triangles) {
          for (test::Point& p : t) p = {p[0] + i, p[1] + j, p[2] + k};
          all.push_back(t);
        }
  return all;
}

test::BoxOptions uneven(unsigned seed) {
  test::BoxOptions options{.n = 4, .sheet = false, .curve = false, .squash = 0.6, .seed = seed};
  options.map << 1, 0.1, 0, 0, 1, 0.2, 0, 0, 1;
  return options;
}

// Operations of all kinds, also ones that are undone later, accepted as long as no tetrahedron is inverted.
TEST(StaysInEnvelope, InBothDirectionsInAStorm) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    TetDomain domain(test::make_box(uneven(seed)).input);
    const NodeId surface = *domain.surface();
    const auto now = [&] {
      return triangles_of(domain.tree(), surface, NodeId::root, domain.points().values);
    };
    const auto before = now();
    constexpr double distance = 0.05;
    const Embedding embedding = domain.embedding();
    improvement::Workspace work(embedding, NodeId::root,
                                {.confined = {{surface, Confined::envelope, distance}}});
    improvement::Counts counts{};
    improvement::Refusals refusals(1);
    improvement::Candidates candidates(work, counts, refusals);
    std::mt19937 random(seed);
    std::size_t on_surface = 0;
    for (int round = 0; round < 40; ++round) {
      Transaction scope = work.operations().transaction();
      for (int i = 0; i < 60; ++i) {
        const improvement::Candidate c = test::random_candidate(work, candidates, random);
        if (c && test::do_it(work, c) != no_dart) on_surface += c.surface;
      }
      if (round % 4 != 0) scope.commit();
    }
    EXPECT_GT(on_surface, 20U) << seed;
    const auto after = now();
    EXPECT_NE(before, after);
    EXPECT_LE(sampled_distance(before, after), distance * rounding) << seed;
    EXPECT_LE(sampled_distance(after, before), distance * rounding) << seed;
    EXPECT_TRUE(test::all_positive(domain)) << seed;
    EXPECT_TRUE(validate(domain.tree()).empty()) << seed;
  }
}

/// The unit cube with two regions, parted by a wavy surface that meets all sides.
PeriodicTile wavy_tile(Index n) {
  PeriodicTile tile = test::cube_tile(n);
  for (std::size_t t = 0; t < tile.facets.size(); ++t) {
    double above = 0;
    for (const Index v : tile.facets.facet(t)) {
      const auto& p = tile.points[v];
      above += std::sin(6.283185307179586 * p[0]) + std::cos(6.283185307179586 * p[1]) +
               std::sin(6.283185307179586 * p[2] + 1);
    }
    tile.regions.push_back(above > 0 ? 1 : 2);
  }
  return tile;
}

PeriodicOptions with_interfaces() {
  PeriodicOptions options = test::along(true, true, true);
  options.interfaces = true;
  return options;
}

TEST(StaysInEnvelope, OfATileModuloTheLattice) {
  for (const TileSides sides : {TileSides::free, TileSides::flat}) {
    PeriodicDomain domain(wavy_tile(6), with_interfaces());
    const std::optional<NodeId> interfaces = domain.listed(2);
    ASSERT_TRUE(interfaces);
    const auto now = [&] {
      return triangles_of(domain.tree(), *interfaces, domain.tile(), domain.positions().values());
    };
    const auto before = now();
    constexpr double distance = 0.06;
    const Embedding embedding = domain.embedding(sides);
    improvement::Workspace work(embedding, domain.tile(),
                                {.confined = {{*interfaces, Confined::envelope, distance}}});
    improvement::Counts counts{};
    improvement::Refusals refusals(1);
    improvement::Candidates candidates(work, counts, refusals);
    std::mt19937 random(7);
    std::array<std::size_t, 2> done{};  // of what has copies
    for (int i = 0; i < 4000; ++i) {
      const improvement::Candidate c = test::random_candidate(work, candidates, random);
      if (!c) continue;
      const bool copied = work.is_copied(work.mesh().vertex(c.dart));
      if (test::do_it(work, c) != no_dart) done[copied] += c.surface;
    }
    EXPECT_GT(done[0], 20U);
    EXPECT_GT(done[1], 10U);
    const auto after = now();
    EXPECT_LE(sampled_distance(before, repeated(after), 4), distance * rounding);
    EXPECT_LE(sampled_distance(after, repeated(before), 4), distance * rounding);
    EXPECT_EQ(test::inverted(domain), 0U);
    EXPECT_LT(domain.mismatch(), 1e-15);
    EXPECT_TRUE(validate(domain.tree()).empty());
  }
}

// --- improvement ---------------------------------------------------------------------------------------

std::map<PeriodicTile::Region, double> volumes(const PeriodicDomain& domain) {
  std::map<PeriodicTile::Region, double> all;
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  for (Index t = 0; t < mesh.capacity(3); ++t)
    if (mesh.is_live(3, t)) all[domain.region(t)] += signed_measure(domain, t, {});
  return all;
}

/// With its inner vertices at random places, also those of the interface.
PeriodicTile crooked(PeriodicTile tile, double step) {
  std::vector<std::vector<std::size_t>> around(tile.points.size());
  for (std::size_t t = 0; t < tile.facets.size(); ++t)
    for (const Index v : tile.facets.facet(t)) around[v].push_back(t);
  const auto is_positive = [&](std::size_t t) {
    const auto v = tile.facets.facet(t);
    const auto p = [&](std::size_t i) { return multimesh::Vec3(tile.points[v[i]]); };
    return dot(cross(p(1) - p(0), p(2) - p(0)), p(3) - p(0)) > 1e-6;
  };
  std::mt19937 random(11);
  for (Index v = 0; v < tile.points.size(); ++v) {
    const auto old = tile.points[v];
    if (std::ranges::any_of(old, [](double x) { return x == 0 || x == 1; })) continue;
    for (double& x : tile.points[v]) x += random_in(random, -step, step);
    if (!std::ranges::all_of(around[v], is_positive)) tile.points[v] = old;
  }
  return tile;
}

TEST(ImproveInEnvelope, GetsBetterThanWhereTheSurfaceIsHeld) {
  std::array<double, 2> mean{};
  for (const bool moves : {false, true}) {
    PeriodicDomain domain(crooked(wavy_tile(6), 0.1), with_interfaces());
    const NodeId interfaces = *domain.listed(2);
    const auto before = volumes(domain);
    const Embedding embedding = domain.embedding();
    ImproveOptions options{.target_amips = 6, .max_passes = 3};
    if (moves) options.confined.push_back({interfaces, Confined::envelope, 0.05});
    mean[moves] = improve(embedding, domain.tile(), options).after.mean_amips;
    for (const auto& [region, volume] : volumes(domain))
      EXPECT_NEAR(volume, before.at(region), (moves ? 1e-3 : 1e-12) * before.at(region) * rounding);
    EXPECT_EQ(test::inverted(domain), 0U);
  }
  EXPECT_LT(mean[1], mean[0]);
}

TEST(ImproveInEnvelope, NeedsASurfaceAndADistance) {
  TetDomain domain(test::make_box({}).input);
  const Embedding embedding = domain.embedding();
  const auto confined = [&](Confinement c) { return ImproveOptions{.confined = {c}}; };
  EXPECT_THROW((void)improve(embedding, NodeId::root, confined({*domain.surface(), Confined::envelope, 0})),
               InputError);
  EXPECT_THROW((void)improve(embedding, NodeId::root, confined({*domain.curves(), Confined::envelope, 1})),
               UsageError);
}

}  // namespace
}  // namespace multimesh
