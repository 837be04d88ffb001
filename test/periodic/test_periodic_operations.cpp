// SPDX-License-Identifier: BSD-3-Clause
// Operations on glued tiles: all copies follow, and stay lattice vectors apart.
#include <gtest/gtest.h>

#include <random>

#include "multimesh/keeps_orientation.hpp"
#include "multimesh/validate.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

/// The vertex of the tile at a place.
Index vertex_at(const PeriodicDomain& domain, const Vec3& p) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  for (Index v = 0; v < mesh.capacity(0); ++v)
    if (mesh.is_live(0, v) && (domain.positions()[v] - p).norm() < 1e-9) return v;
  return no_index;
}

/// A dart (a, b, ..) of the tile.
Dart edge(const PeriodicDomain& domain, const Vec3& a, const Vec3& b) {
  const Mesh& mesh = domain.tree().mesh(domain.tile());
  DartBuffer star;
  mesh.star(mesh.dart_of(0, vertex_at(domain, a)), 0, star);
  for (const Dart t : star)
    for (std::uint8_t p = 0; p < (mesh.dimension() == 3 ? 24 : 6); ++p) {
      const Dart d = mesh.reorder(t, {p});
      Index v[4];
      mesh.vertices(d, v);
      if (v[0] == vertex_at(domain, a) && v[1] == vertex_at(domain, b)) return d;
    }
  return no_dart;
}

struct Walls {
  PeriodicDomain domain{cube_tile(4), along(true, true, true)};
  Propagation operations{domain.tree()};
  KeepsOrientation positive{domain.positions()};
  Walls() {
    domain.attach(operations);
    operations.add(positive);
  }
  void expect_sound() {
    EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
    EXPECT_LE(domain.mismatch(), 1e-12);
  }
};

TEST(PeriodicSplit, PutsTheNewVertexOnAllCopiesOfTheEdge) {
  Walls w;  // an edge of the cube: four copies
  const auto done = w.operations.split(w.domain.tile(), edge(w.domain, {0, 0, 0.25}, {0, 0, 0.5}), 0.3);
  ASSERT_TRUE(done);
  EXPECT_EQ(w.operations.copies().count(w.domain.tile()), 4U);
  for (const double x : {0.0, 1.0})
    for (const double y : {0.0, 1.0}) EXPECT_NE(vertex_at(w.domain, {x, y, 0.325}), no_index);
  w.expect_sound();
}

TEST(PeriodicSplit, InterpolatesTheSameInAllCopiesToRounding) {
  Walls w;
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const Mesh& root = w.domain.tree().mesh(NodeId::root);
    const Dart at = root.dart_of(3, static_cast<Index>(random() % root.capacity(3)));
    const auto order = static_cast<std::uint8_t>(random() % 24);
    ASSERT_TRUE(w.operations.split(NodeId::root, root.reorder(at, {order}), 0.37));
  }
  w.expect_sound();
}

TEST(PeriodicCollapse, MergesOnTheSidesInAllCopies) {
  Walls w;
  // Both ends on the same side: two copies each, and of the edge.
  const Dart e = edge(w.domain, {0, 0.25, 0.25}, {0, 0.5, 0.25});
  const auto done = w.operations.collapse(w.domain.tile(), e, Placement::at(0.5));
  ASSERT_TRUE(done) << to_string(done.refusal.check);
  EXPECT_NE(vertex_at(w.domain, {0, 0.375, 0.25}), no_index);
  EXPECT_NE(vertex_at(w.domain, {1, 0.375, 0.25}), no_index);
  w.expect_sound();
}

TEST(PeriodicCollapse, HoldsTheEndWithMoreCopies) {
  Walls w;
  const Index corner = vertex_at(w.domain, {0, 0, 0});
  const Dart e = edge(w.domain, {0, 0, 0}, {0.25, 0, 0});
  const auto done = w.operations.collapse(w.domain.tile(), e, Placement::at(1));  // not where it is wanted
  ASSERT_TRUE(done) << to_string(done.refusal.check);
  EXPECT_EQ(w.domain.tree().mesh(w.domain.tile()).vertex(done.dart), corner);
  EXPECT_NE(vertex_at(w.domain, {0, 0, 0}), no_index);
  EXPECT_EQ(vertex_at(w.domain, {0.25, 0, 0}), no_index);
  EXPECT_EQ(vertex_at(w.domain, {0.25, 1, 1}), no_index);
  w.expect_sound();
}

TEST(PeriodicMove, TakesAllCopiesAlong) {
  Walls w;
  const Mesh& mesh = w.domain.tree().mesh(w.domain.tile());
  const Vec3 by(0.03, -0.02, 0.01);
  const std::vector<std::pair<Vec3, std::uint32_t>> cases{
      {{0.25, 0.25, 0.25}, 1}, {{1, 0.5, 0.25}, 2}, {{0.5, 0, 1}, 4}, {{1, 0, 1}, 8}};
  for (const auto& [p, copies] : cases) {
    const Index v = vertex_at(w.domain, p);
    const auto before = w.domain.positions().values();
    ASSERT_TRUE(w.domain.move(w.operations, w.domain.tile(), mesh.dart_of(0, v), by));
    EXPECT_EQ(w.operations.copies().count(w.domain.tile()), copies);
    std::uint32_t moved = 0;
    for (Index u = 0; u < before.size(); ++u)
      if (before[u] != w.domain.positions()[u]) {
        ++moved;
        EXPECT_LE((w.domain.positions()[u] - before[u] - by).norm(), 1e-15);
      }
    EXPECT_EQ(moved, copies);
    w.expect_sound();
  }
}

TEST(PeriodicMove, LooksAtTheFacetsOfAllCopies) {
  Walls w;
  // From the side x = 0 inward: harmless there for a while, but not for the facets at the copy on x = 1.
  // A displacement of one cell outward turns facets over at one of the two copies, whichever is asked.
  const Mesh& mesh = w.domain.tree().mesh(w.domain.tile());
  for (const double x : {0.0, 1.0})
    for (const double sign : {-1.0, 1.0}) {
      const Dart d = mesh.dart_of(0, vertex_at(w.domain, {x, 0.5, 0.25}));
      const auto before = w.domain.positions().values();
      const Outcome far = w.domain.move(w.operations, w.domain.tile(), d, {0.3 * sign, 0, 0});
      EXPECT_EQ(far.refusal.check, Check::invariant);
      EXPECT_EQ(far.refusal.invariant, "facets keep their orientation");
      EXPECT_EQ(w.domain.positions().values(), before);
    }
  w.expect_sound();
}

TEST(PeriodicSwap, IsRefusedOnTheSidesOnly) {
  PeriodicDomain domain(square_tile(4, 4), along(true, true, false));
  Propagation operations(domain.tree());
  domain.attach(operations);
  const auto side = operations.swap(domain.tile(), edge(domain, {0, 0.25, 0}, {0, 0.5, 0}));
  EXPECT_EQ(side.refusal.check, Check::flip);
  EXPECT_TRUE(operations.swap(domain.tile(), edge(domain, {0, 0.25, 0}, {0.25, 0.5, 0})));
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  EXPECT_LE(domain.mismatch(), 1e-15);
}

TEST(PeriodicDomainPlaces, AreThoseOfACopyForEveryMesh) {
  PeriodicDomain domain(cube_tile(3), along(true, true, false));
  const auto surface = domain.add_surface();
  ASSERT_TRUE(surface);
  const Mesh& mesh = domain.tree().mesh(*surface);
  for (Index v = 0; v < mesh.capacity(0); ++v) {
    const double z = domain.place(*surface, mesh.dart_of(0, v))[2];
    EXPECT_TRUE(z == 0 || z == 1);
  }
  const Mesh& root = domain.tree().mesh(NodeId::root);
  for (Index v = 0; v < root.capacity(0); ++v) {
    const auto p = domain.place(NodeId::root, root.dart_of(0, v));
    EXPECT_NE(vertex_at(domain, p), no_index);
  }
}

TEST(PeriodicDecimation, StopsBySelfAtAComplex) {
  PeriodicDomain domain(cube_tile(4), along(true, true, true));
  Propagation operations(domain.tree());
  domain.attach(operations);
  const Mesh& root = domain.tree().mesh(NodeId::root);
  for (bool changed = true; changed;) {
    changed = false;
    for (Index t = 0; t < root.capacity(3); ++t)
      for (std::uint8_t p = 0; p < 24 && root.is_live(3, t); ++p)
        changed |= bool(operations.collapse(NodeId::root, root.reorder(root.dart_of(3, t), {p})));
  }
  std::size_t vertices = 0;
  for (Index v = 0; v < root.capacity(0); ++v) vertices += root.is_live(0, v);
  EXPECT_GE(vertices, 15U);  // fewer do not make a 3-torus
  EXPECT_LE(vertices, 40U);
  EXPECT_EQ(validate(domain.tree()), std::vector<std::string>{});
  EXPECT_LE(domain.mismatch(), 1e-12);
}

}  // namespace
}  // namespace multimesh::test
