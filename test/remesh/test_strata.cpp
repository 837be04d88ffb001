// SPDX-License-Identifier: BSD-3-Clause
// Where vertices may go, by the maps of a tree.
#include <gtest/gtest.h>

#include "multimesh/strata.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

//   A grid of 6 x 6; vertex (i,j) has the index 7 i + j. A curve along j = 3 from i = 1 to 5.
class OnAGrid : public testing::Test {
 protected:
  OnAGrid() : tree_(grid(6, 6)) {}
  static Index at(int i, int j) { return static_cast<Index>(7 * i + j); }
  std::function<bool(Index)> between(std::function<bool(Index, Index)> both) {
    const Mesh& root = tree_.tree->mesh(NodeId::root);
    return [&root, both](Index e) {
      const Dart d = root.dart_of(1, e);
      return both(root.vertex(d), root.vertex(root.reorder(d, exchange_ends)));
    };
  }
  std::function<bool(Index)> row(Index j, Index from, Index to) {
    return between([=](Index v, Index w) {
      const auto on = [&](Index x) { return x % 7 == j && x / 7 >= from && x / 7 <= to; };
      return on(v) && on(w);
    });
  }
  Freedom freedom(Index v) {
    return Strata(*tree_.tree).freedom(tree_.tree->mesh(NodeId::root).dart_of(0, v));
  }

  Tree tree_;
};

TEST_F(OnAGrid, TheBoundaryIsALine) {
  EXPECT_EQ(freedom(at(3, 3)), Freedom::surface);
  EXPECT_EQ(freedom(at(0, 3)), Freedom::line);
  EXPECT_EQ(freedom(at(0, 0)), Freedom::line);
  EXPECT_EQ(freedom(at(6, 0)), Freedom::line);  // one of the corners at (6,0) and (0,6) has a single triangle
  EXPECT_EQ(freedom(at(0, 6)), Freedom::line);
}

TEST_F(OnAGrid, ACurveIsOneUpToItsEnds) {
  tree_.add_tagged(NodeId::root, 1, row(3, 1, 5));
  EXPECT_EQ(freedom(at(3, 3)), Freedom::line);
  EXPECT_EQ(freedom(at(1, 3)), Freedom::none);
  EXPECT_EQ(freedom(at(5, 3)), Freedom::none);
  EXPECT_EQ(freedom(at(3, 2)), Freedom::surface);
}

TEST_F(OnAGrid, ACurveThatMeetsTheBoundaryEndsThereForBoth) {
  tree_.add_tagged(NodeId::root, 1, row(3, 0, 5));
  EXPECT_EQ(freedom(at(0, 3)), Freedom::none);
  EXPECT_EQ(freedom(at(1, 3)), Freedom::line);
}

TEST_F(OnAGrid, CurvesOfTwoMeshesChangeTheKindWhereOneEnds) {
  tree_.add_tagged(NodeId::root, 1, row(3, 1, 5));
  tree_.add_tagged(NodeId::root, 1, row(3, 3, 5));
  EXPECT_EQ(freedom(at(2, 3)), Freedom::line);
  EXPECT_EQ(freedom(at(3, 3)), Freedom::none);
  EXPECT_EQ(freedom(at(4, 3)), Freedom::line);
}

TEST_F(OnAGrid, ASeamIsALineAndItsEndStays) {
  tree_.add_cut(NodeId::root, row(3, 0, 4));
  EXPECT_EQ(freedom(at(2, 3)), Freedom::line);
  EXPECT_EQ(freedom(at(4, 3)), Freedom::none);
  EXPECT_EQ(freedom(at(0, 3)), Freedom::none);  // the boundary changes its copies there
  EXPECT_EQ(freedom(at(5, 3)), Freedom::surface);
}

TEST_F(OnAGrid, ABoundaryOfAPartIsALine) {
  const Mesh& root = tree_.tree->mesh(NodeId::root);
  tree_.add_tagged(NodeId::root, 2, [&](Index f) {
    Index v[4];
    root.vertices(root.dart_of(2, f), v);
    return v[0] % 7 <= 3 && v[1] % 7 <= 3 && v[2] % 7 <= 3;
  });
  EXPECT_EQ(freedom(at(3, 3)), Freedom::line);
  EXPECT_EQ(freedom(at(0, 3)), Freedom::none);
  EXPECT_EQ(freedom(at(3, 1)), Freedom::surface);
}

}  // namespace
}  // namespace multimesh::test
