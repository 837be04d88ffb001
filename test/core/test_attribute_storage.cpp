// SPDX-License-Identifier: BSD-3-Clause
// Attributes over vectors of the caller's own: they grow and shrink with the mesh; wrong sizes are refused.
#include <gtest/gtest.h>

#include <numeric>

#include "multimesh/column.hpp"
#include "test/core/drawn.hpp"

namespace multimesh::test {
namespace {

TEST(AttributeOverAPlainVector, GrowsWithItsMesh) {
  Tree t = two_neighbors_plus_one();
  const Mesh& root = t.tree->mesh(NodeId::root);
  std::vector<double> values(root.capacity(0));
  std::iota(values.begin(), values.end(), 0.0);
  VertexAttribute<double> attribute(NodeId::root, values);
  t.operations->add(attribute);
  for (int i = 0; i < 200; ++i) {
    const Outcome o = t.operations->split(NodeId::root, root.dart_of(1, static_cast<Index>(i)), 0.25);
    ASSERT_TRUE(o);
    const Index a = root.vertex(o.dart), c = root.vertex(root.reorder(o.dart, exchange_ends));
    ASSERT_EQ(values.size(), root.capacity(0));
    EXPECT_GE(values[c], std::min(values[a], 0.0));
    EXPECT_LE(values[c], 4);
  }
}

TEST(AttributeOverAPlainVector, ShrinksWhenItsMeshDoes) {
  Tree t = two_neighbors_plus_one();
  const Mesh& root = t.tree->mesh(NodeId::root);
  std::vector<int> values(root.capacity(0), 3), tags(root.capacity(1), 5),
      of_corners(root.corner_capacity(), 7);
  std::iota(of_corners.begin(), of_corners.end(), 0);
  VertexAttribute<int> attribute(NodeId::root, values);
  Column<int> column(NodeId::root, 1, tags), corner_column(NodeId::root, corners, of_corners);
  t.operations->add(attribute).add(column).add(corner_column);
  const auto before = std::tuple(values, tags, of_corners);
  {
    const auto scope = t.operations->transaction();
    for (Index e = 0; e < 20; ++e) ASSERT_TRUE(t.operations->split(NodeId::root, root.dart_of(1, e)));
    for (Index e = 0; e < 20; ++e)
      if (root.is_live(1, e)) (void)t.operations->collapse(NodeId::root, root.dart_of(1, e));
    EXPECT_EQ(values.size(), root.capacity(0));
    EXPECT_EQ(tags.size(), root.capacity(1));
    EXPECT_EQ(of_corners.size(), root.corner_capacity());
  }
  EXPECT_EQ(std::tuple(values, tags, of_corners), before);
}

TEST(AttributeOverAPlainVector, FollowsSpareElementsOfProtectedProperties) {
  Tree t = two_neighbors_plus_one();
  const Mesh& root = t.tree->mesh(NodeId::root);
  std::vector<int> values(root.capacity(0), 3), tags(root.capacity(1), 5);
  VertexAttribute<int> attribute(NodeId::root, values);
  Column<int> column(NodeId::root, 1, tags);
  t.operations->add(attribute).add(column).protect_properties(true);
  for (Index e = 0; e < 10; ++e) {
    if (!root.is_live(1, e)) continue;
    (void)t.operations->split(NodeId::root, root.dart_of(1, e));
    ASSERT_GE(values.size(), root.capacity(0));
    ASSERT_GE(tags.size(), root.capacity(1));
  }
}

TEST(AttributeOverAPlainVector, IsRefusedIfItIsTooShort) {
  Tree t = two_neighbors_plus_one();
  const Mesh& root = t.tree->mesh(NodeId::root);
  std::vector<int> values(root.capacity(0) - 1), tags(root.capacity(1) - 1);
  VertexAttribute<int> attribute(NodeId::root, values);
  Column<int> column(NodeId::root, 1, tags);
  EXPECT_THROW(t.operations->add(attribute), UsageError);
  EXPECT_THROW(t.operations->add(column), UsageError);
  // And later, when somebody has resized it.
  values.resize(root.capacity(0));
  t.operations->add(attribute);
  values.pop_back();
  const Dart e = edge(t, NodeId::root, 0, 1);
  EXPECT_THROW((void)t.operations->split(NodeId::root, e), UsageError);
  values.resize(root.capacity(0));
  EXPECT_TRUE(t.operations->split(NodeId::root, e));
}

TEST(AttributeOverAPlainVector, MustBeMovedByTheCallerWhenItsMeshIsCompacted) {
  Tree t = two_neighbors_plus_one();
  const Mesh& root = t.tree->mesh(NodeId::root);
  std::vector<int> values(root.capacity(0));
  VertexAttribute<int> attribute(NodeId::root, values);
  t.operations->add(attribute);
  (void)t.tree->compact();  // moves nothing
  ASSERT_TRUE(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 0, 4)));
  (void)t.tree->compact();
  EXPECT_THROW((void)t.operations->split(NodeId::root, edge(t, NodeId::root, 0, 1)), UsageError);
  values.resize(root.capacity(0));
  EXPECT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 0, 1)));
}

TEST(Column, IsRefusedWhereNothingIsStored) {
  Tree t = two_neighbors();
  std::vector<int> values;
  EXPECT_THROW((Column<int>(NodeId::root, 0, values)), UsageError);
  Column<int> of_tetrahedra(NodeId::root, 3, values);
  EXPECT_THROW(t.operations->add(of_tetrahedra), UsageError);
  const auto solid = solid_tree_kinds().front().make(10, 1);
  for (const int k : {1, 2, corners}) {
    Column<int> column(NodeId::root, k, values);
    EXPECT_THROW(solid->operations->add(column), UsageError) << k;
  }
}

}  // namespace
}  // namespace multimesh::test
