// SPDX-License-Identifier: BSD-3-Clause
// Distances from the input, and the shapes of triangles.
#include <gtest/gtest.h>

#include <numbers>

#include "multimesh/algorithms/remeshing/distance_guard.hpp"
#include "multimesh/algorithms/remeshing/star_shape.hpp"
#include "multimesh/keeps_orientation.hpp"
#include "multimesh/openmesh/triangle_mesh.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

using namespace remeshing;

/// A pyramid over a square: the tip, vertex 0, is 1 high.
class Pyramid : public testing::Test {
 protected:
  Pyramid()
      : tree_({{2, 5, {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1}}, std::vector<Point>(5)}),
        at_{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
        positions_(NodeId::root, at_),
        embedding_(*tree_.tree) {
    embedding_.add(positions_);
    embedding_.add_coordinates(positions_, Embedding::Kind::space);
    surface_ = std::make_unique<EmbeddedMesh>(embedding_, NodeId::root);
    root().star(root().dart_of(0, 0), 0, star_);
  }
  const Mesh& root() const { return tree_.tree->mesh(NodeId::root); }
  const Coordinates& positions() const { return surface_->positions(); }

  Tree tree_;
  std::vector<Vec3> at_;
  VertexAttribute<Vec3> positions_;
  Embedding embedding_;
  std::unique_ptr<EmbeddedMesh> surface_;
  DartBuffer star_;
};

TEST_F(Pyramid, TheTipMayNotGoFarFromWhereItWas) {
  Strata strata(*tree_.tree);
  std::vector<Index> patch(root().capacity(2)), line(root().capacity(1));
  const Reference input(*surface_, strata, patch, line);
  DistanceGuard guard(root(), positions(), input, 0.2, 0.5);
  const auto settles = [&](double height) {
    const Vec3 was = at_[0];
    at_[0][2] = height;
    guard.take(star_);
    const bool good = guard.settle(star_);
    if (!good) guard.give_back(), at_[0] = was;
    return good;
  };
  EXPECT_TRUE(settles(0.9));
  EXPECT_FALSE(settles(0.6));  // the tip of the input would be 0.4 above
  EXPECT_TRUE(settles(0.85));
  EXPECT_FALSE(settles(0.75));  // counted from the input, not from the last place
  EXPECT_TRUE(settles(1.1));
}

TEST_F(Pyramid, PlacesAreOnThePatchThatLooksTheSameWay) {
  Strata strata(*tree_.tree);
  std::vector<Index> patch(root().capacity(2)), line(root().capacity(1));
  const Reference input(*surface_, strata, patch, line);
  const auto above = input.on_patch(patch[0], {0, 0, 3}, {0, 0, 1}, 0.1);
  ASSERT_TRUE(above);
  EXPECT_NEAR((above->position - Vec3(0, 0, 1)).norm(), 0, 1e-12);
  EXPECT_FALSE(input.on_patch(patch[0], {0, 0, 3}, {0, 0, -1}, 3));
  EXPECT_FALSE(input.on_patch(patch[0] + 1, {0, 0, 3}, {0, 0, 1}, 0.1));
  const auto rim = input.on_line(1, {0, 3, 1}, 9);  // the boundary is the only line
  ASSERT_TRUE(rim);
  EXPECT_NEAR((rim->position - Vec3(0, 1, 0)).norm(), 0, 1e-12);
  EXPECT_FALSE(input.on_line(2, {0, 3, 1}, 9));
  EXPECT_TRUE(input.has_within({0, 0, 1.1}, 0.11));
  EXPECT_FALSE(input.has_within({0, 0, 1.1}, 0.05));
}

TEST_F(Pyramid, TrianglesMayNotTurnOver) {
  StarShape in_space(root(), positions());
  KeepsOrientation in_plane(positions(), root());
  const Dart tip = root().dart_of(0, 0);
  EXPECT_TRUE(in_space.allows(tip, {0.1, 0, 1}));
  EXPECT_FALSE(in_space.allows(tip, {0, 0, -1}));
  EXPECT_TRUE(in_plane.allows(root(), tip, {0.1, 0.1, 0}));
  EXPECT_FALSE(in_plane.allows(root(), tip, {2, 0, 0}));
  EXPECT_FALSE(in_plane.allows(root(), tip, {1, 0, 0}));  // without area
}

TEST(LeastAngle, IsThatOfTheTriangle) {
  EXPECT_NEAR(least_angle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), std::numbers::pi / 4, 1e-15);
  EXPECT_NEAR(least_angle({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}), std::numbers::pi / 3, 1e-15);
  EXPECT_EQ(least_angle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0);
}

}  // namespace
}  // namespace multimesh::test
