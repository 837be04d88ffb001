// SPDX-License-Identifier: BSD-3-Clause
// Lists of values that a mesh owns, whatever its data structure.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "multimesh/domains/make_mesh.hpp"
#include "multimesh/operations.hpp"

namespace multimesh::test {
namespace {

/// Two simplices with a common face.
FacetList two_simplices(int d) {
  if (d == 1) return {1, 3, {0, 1, 1, 2}};
  if (d == 2) return {2, 4, {0, 1, 2, 2, 1, 3}};
  return {3, 5, {0, 1, 2, 3, 1, 0, 2, 4}};
}

class MeshValues : public testing::TestWithParam<int> {};

TEST_P(MeshValues, GrowWithTheMeshAndAreUndoneWithIt) {
  const int d = GetParam();
  MultiMesh tree(make_mesh(two_simplices(d)));
  Mesh& mesh = tree.mesh(NodeId::root);
  auto& names = mesh.add_values<std::string>(d, "name");
  auto& numbers = mesh.add_values<Index>(0, "number");
  ASSERT_EQ(names.size(), mesh.capacity(d));
  ASSERT_EQ(numbers.size(), mesh.capacity(0));
  names = {"left", "right"};
  for (Index v = 0; v < numbers.size(); ++v) numbers[v] = v + 10;
  const auto names_before = names;
  const auto numbers_before = numbers;
  Propagation operations(tree);
  const Dart edge = mesh.dart_of(1, 0);
  DartBuffer star;
  mesh.star(edge, 1, star);
  std::size_t lefts = 0, new_lefts = 0;
  for (const Dart t : star) lefts += names[mesh.facet(t)] == "left";
  {
    const Transaction undone = operations.transaction();
    ASSERT_TRUE(operations.split(NodeId::root, edge));
    EXPECT_EQ(numbers.size(), mesh.capacity(0));
    ASSERT_EQ(names.size(), mesh.capacity(d));
    for (Index f = 0; f < names.size(); ++f) new_lefts += mesh.is_live(d, f) && names[f] == "left";
    EXPECT_EQ(new_lefts, 1 + lefts);  // both halves have the value of the whole
  }
  EXPECT_EQ(names, names_before);
  EXPECT_EQ(numbers, numbers_before);
}

TEST_P(MeshValues, MoveAlongWhenTheMeshIsCompacted) {
  const int d = GetParam();
  MultiMesh tree(make_mesh(two_simplices(d)));
  Mesh& mesh = tree.mesh(NodeId::root);
  auto& numbers = mesh.add_values<Index>(0, "number");
  for (Index v = 0; v < numbers.size(); ++v) numbers[v] = v;
  Propagation operations(tree);
  Index gone = no_index;
  for (Index e = 0; e < mesh.capacity(1) && gone == no_index; ++e) {
    const Dart edge = mesh.dart_of(1, e);
    const Index a = mesh.vertex(edge);
    if (operations.collapse(NodeId::root, edge, Placement::keep_b())) gone = a;
  }
  ASSERT_NE(gone, no_index);
  tree.compact();
  ASSERT_EQ(numbers.size(), mesh.capacity(0));
  EXPECT_EQ(std::ranges::count(numbers, gone), 0);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, MeshValues, testing::Values(1, 2, 3));

TEST(MeshValuesOfTetrahedra, AreNotOnEdgesAndFaces) {
  const auto mesh = make_mesh(two_simplices(3));
  EXPECT_THROW((void)mesh->add_values<int>(1, "edge"), UsageError);
  EXPECT_THROW((void)mesh->add_values<int>(2, "face"), UsageError);
}

}  // namespace
}  // namespace multimesh::test
