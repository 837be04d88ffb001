// SPDX-License-Identifier: BSD-3-Clause
// The single operations: what is predicted is what comes out, and what must be refused is.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>

#include "multimesh/algorithms/improvement/candidates.hpp"
#include "multimesh/algorithms/improvement/exact_place.hpp"
#include "test/improve/made_domain.hpp"
#include "test/improve/random_operations.hpp"

namespace multimesh::improvement {
namespace {

using test::BoxOptions;
using test::do_it;
using test::Kept;
using test::make_box;
using test::random_candidate;

TEST(Operations, InAStormKeepEverything) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    BoxOptions options;
    options.squash = 0.5;
    options.seed = seed;
    if (seed % 2 == 0) options.map << 2, 1, 0, -1, 2, 1, 1, 0, 3;
    TetDomain domain(make_box(options).input);
    const Kept kept(domain);
    const Embedding embedding = domain.embedding();
    Workspace work(embedding, NodeId::root, {});
    Counts counts{};
    Refusals refusals(1);
    Candidates candidates(work, counts, refusals);
    std::mt19937 random(seed);
    std::array<int, n_kinds> done{};
    for (int i = 0; i < 3000; ++i) {
      const Candidate c = random_candidate(work, candidates, random);
      if (!c) continue;
      const Dart at = do_it(work, c);
      if (at == no_dart) continue;
      ++done[static_cast<std::size_t>(c.kind)];
      if (i % 250 == 0) {
        ASSERT_EQ(kept.fault(domain), "") << seed << ' ' << i;
      }
    }
    EXPECT_EQ(kept.fault(domain), "") << seed;
    for (const int n : done) EXPECT_GT(n, 10) << seed;
  }
}

/// The live tetrahedra by number, each with its corners.
std::map<Index, std::set<Index>> numbered(const Workspace& work) {
  std::map<Index, std::set<Index>> tets;
  for (Index t = 0; t < work.mesh().capacity(3); ++t) {
    if (!work.is_live(t)) continue;
    const Corners c = work.corners(t);
    tets[t] = {c.begin(), c.end()};
  }
  return tets;
}

// What remembers tetrahedra by their numbers relies on this.
TEST(Operations, OfFacesRenumberAroundTheFirstTwoCornersOnly) {
  TetDomain domain(make_box({.squash = 0.9}).input);
  const Embedding embedding = domain.embedding();
  Workspace work(embedding, NodeId::root, {});
  Counts counts{};
  Refusals refusals(1);
  Candidates candidates(work, counts, refusals);
  int done = 0;
  for (Index t = 0; t < work.mesh().capacity(3); ++t) {
    if (!work.is_live(t)) continue;
    Candidate c;
    Demand any;
    any.enough = flat;
    candidates.face_swap(work.dart(t), any, c);
    if (!c) continue;
    const std::map<Index, std::set<Index>> before = numbered(work);
    Index face[4];
    work.mesh().vertices(c.dart, face);
    const Dart at = do_it(work, c);
    if (at == no_dart) continue;
    ++done;
    for (const auto& [number, corners] : numbered(work)) {
      const auto old = before.find(number);
      if (old != before.end() && old->second == corners) continue;
      EXPECT_TRUE(corners.contains(work.mesh().vertex(at)) || corners.contains(face[0]) ||
                  corners.contains(face[1]));
    }
  }
  EXPECT_GT(done, 20);
}

TEST(Operations, GiveWhatWasPredicted) {
  TetDomain domain(make_box({.squash = 0.9}).input);
  const Embedding embedding = domain.embedding();
  Workspace work(embedding, NodeId::root, {});
  Counts counts{};
  Refusals refusals(1);
  Candidates candidates(work, counts, refusals);
  std::mt19937 random(5);
  std::array<int, n_kinds> compared{};
  for (int i = 0; i < 1500; ++i) {
    const Candidate c = random_candidate(work, candidates, random);
    if (!c) continue;
    Index v[4];
    work.mesh().vertices(c.dart, v);
    const Dart at = do_it(work, c);
    if (at == no_dart) continue;
    std::vector<Corners> star;
    work.read_star(at, star);
    const auto has = [](const Corners& t, Index x) { return std::find(t.begin(), t.end(), x) != t.end(); };
    double worst = 0;
    for (const Corners& t : star) {
      const bool is_new = c.kind == Kind::split || c.kind == Kind::smoothing ||
                          (c.kind == Kind::edge_swap && (has(t, v[0]) != has(t, v[1])));
      if (is_new) worst = std::max(worst, work.quality_of(t));
    }
    if (c.kind == Kind::collapse || c.kind == Kind::face_swap) continue;
    ++compared[static_cast<std::size_t>(c.kind)];
    if (c.kind == Kind::edge_swap) {
      EXPECT_GE(worst, c.after * (1 - 1e-9));  // others at the apex may be as bad
    } else {
      EXPECT_NEAR(worst, c.after, 1e-9 * c.after);
    }
  }
  EXPECT_GT(compared[static_cast<std::size_t>(Kind::split)], 10);
  EXPECT_GT(compared[static_cast<std::size_t>(Kind::smoothing)], 10);
  EXPECT_GT(compared[static_cast<std::size_t>(Kind::edge_swap)], 10);
}

TEST(Operations, TrialsAreUndone) {
  TetDomain domain(make_box({.squash = 0.9}).input);
  const Embedding embedding = domain.embedding();
  Workspace work(embedding, NodeId::root, {});
  Counts counts{};
  Refusals refusals(1);
  Candidates candidates(work, counts, refusals);
  std::mt19937 random(9);
  const TaggedTetrahedra before = domain.tagged();
  for (int trial = 0; trial < 20; ++trial) {
    Transaction scope = work.operations().transaction();
    for (int i = 0; i < 60; ++i)
      if (const Candidate c = random_candidate(work, candidates, random)) (void)do_it(work, c);
  }
  const TaggedTetrahedra after = domain.tagged();
  EXPECT_EQ(before.points, after.points);
  EXPECT_EQ(before.tets.corners, after.tets.corners);
  EXPECT_EQ(before.regions, after.regions);
  EXPECT_EQ(before.patches, after.patches);
}

TEST(Diagonals, AreExchangedInConvexPlaneQuadranglesOnly) {
  const Vec3 a(0, 0, 0), b(1, 1, 0), x(1, 0, 0), y(0, 1, 0);
  EXPECT_TRUE(may_exchange_diagonals(a, b, x, y));
  EXPECT_TRUE(may_exchange_diagonals(b, a, x, y));
  EXPECT_FALSE(may_exchange_diagonals(a, b, x, Vec3(0, 1, 1e-300)));   // not plane
  EXPECT_FALSE(may_exchange_diagonals(a, b, x, Vec3(0.75, 0.25, 0)));  // on the same side
  EXPECT_FALSE(may_exchange_diagonals(a, b, x, Vec3(-1, 0, 0)));       // a triangle
  EXPECT_FALSE(may_exchange_diagonals(a, b, x, Vec3(-2, -1, 0)));      // concave
  EXPECT_TRUE(lies_flat(a, b, x, y));
  EXPECT_FALSE(lies_flat(a, b, x, Vec3(0.75, 0.25, 0)));
  EXPECT_TRUE(lies_flat_split_at(a, b, x, y, Vec3(0.5, 0.25, 0)));
  EXPECT_FALSE(lies_flat_split_at(a, b, x, y, Vec3(0.5, 0.25, 1e-300)));
  EXPECT_FALSE(lies_flat_split_at(a, b, x, y, Vec3(1.5, 0.25, 0)));
}

}  // namespace
}  // namespace multimesh::improvement
