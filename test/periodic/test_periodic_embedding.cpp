// SPDX-License-Identifier: BSD-3-Clause
// Algorithms for any surface, on a tile and on the surface of the material in one: all copies move together.
#include <gtest/gtest.h>

#include "multimesh/embedding.hpp"
#include "test/periodic/tiles.hpp"

namespace multimesh::test {
namespace {

TEST(PeriodicEmbedding, ACopyTakesTheOthersAlong) {
  PeriodicDomain domain(cube_tile(4), along(true, true, true));
  const Embedding embedding = domain.embedding();
  EmbeddedMesh tile(embedding, domain.tile());
  const Vec3 by(0.03, -0.02, 0.01);
  for (Index v = 0; v < tile.mesh().capacity(0); ++v) {
    const auto before = domain.positions().values();
    const Outcome o = tile.operations().relocate(domain.tile(), tile.mesh().dart_of(0, v), [&](const Event&) {
      tile.positions().set(v, tile.positions().at(v) + by);
    });
    if (!o) continue;
    std::size_t moved = 0;
    for (Index u = 0; u < before.size(); ++u)
      if (before[u] != domain.positions()[u]) {
        ++moved;
        EXPECT_LE((domain.positions()[u] - before[u] - by).norm(), 1e-15);
      }
    EXPECT_EQ(moved, tile.operations().copies().count(domain.tile()));
  }
  EXPECT_TRUE(copies_fit(domain));
  EXPECT_EQ(inverted(domain), 0U);
}

TEST(PeriodicEmbedding, NewVerticesAreTheSameInAllCopies) {
  PeriodicOptions oblique = along(true, true, false);
  oblique.periods = {{{1, 0, 0}, {std::sqrt(0.2), std::sqrt(0.7), 0}, {}}};
  PeriodicTile tile = square_tile(5, 4);
  for (auto& p : tile.points) p = {p[0] + std::sqrt(0.2) * p[1], std::sqrt(0.7) * p[1], 0};
  PeriodicDomain domain(tile, oblique);
  const Embedding embedding = domain.embedding();
  EmbeddedMesh mesh(embedding, domain.tile());
  for (int i = 0; i < 100; ++i) {
    const Index e = static_cast<Index>(i * 7) % mesh.mesh().capacity(1);
    ASSERT_TRUE(mesh.operations().split(domain.tile(), mesh.mesh().dart_of(1, e), 0.37));
  }
  EXPECT_LE(domain.mismatch(), 1e-15);
  EXPECT_EQ(inverted(domain), 0U);
}

TEST(PeriodicEmbedding, TheRootHasNoPositions) {
  PeriodicDomain domain(square_tile(4, 4), along(true, true, false));
  EXPECT_THROW(EmbeddedMesh(domain.embedding(), NodeId::root), UsageError);
}

}  // namespace
}  // namespace multimesh::test
