// SPDX-License-Identifier: BSD-3-Clause
// Maps up, down and across, on trees of all kinds, against brute force over vertex images.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "oracle/image.hpp"
#include "test/core/drawn.hpp"

namespace multimesh::test {
namespace {

std::vector<Index> leading(const Mesh& mesh, Dart d, int k) {
  std::vector<Index> v(4);
  mesh.vertices(d, v.data());
  v.resize(static_cast<std::size_t>(k) + 1);
  return v;
}

oracle::Simplex as_simplex(std::vector<Index> v) {
  std::sort(v.begin(), v.end());
  oracle::Simplex s{static_cast<int>(v.size()), {}};
  for (std::size_t i = 0; i < v.size(); ++i) s.v[i] = static_cast<int>(v[i]);
  return s;
}

/// The trees of all tests here: made by the oracle's generator, then changed by a few operations.
class Queries : public testing::TestWithParam<unsigned> {
 protected:
  Queries()
      : owner_(GetParam() < 60 ? random_small_tree(GetParam()) : random_small_solid_tree(GetParam(), 10)),
        tree_(*owner_->tree) {
    for (unsigned i = 0; i < 6; ++i) {
      const DartBuffer darts = all_darts(tree_.mesh(NodeId::root));
      const Dart d = darts[(7 * i + GetParam()) % darts.size()];
      (void)(i % 2 ? owner_->operations->collapse(NodeId::root, d)
                   : owner_->operations->split(NodeId::root, d));
    }
  }
  int dimension(NodeId n) const { return tree_.mesh(n).dimension(); }
  /// All darts; of a tetrahedral mesh every fifth, which is prime to their number per facet.
  static DartBuffer some_darts(const Mesh& mesh) {
    const DartBuffer all = all_darts(mesh);
    DartBuffer some;
    for (std::size_t i = 0; i < all.size(); i += mesh.dimension() == 3 ? 5 : 1) some.push_back(all[i]);
    return some;
  }

  std::unique_ptr<Tree> owner_;
  const MultiMesh& tree_;
};

TEST_P(Queries, GoUpByTheVertexMap) {
  const oracle::Tree plain_tree = oracle_tree(tree_);
  for (std::size_t i = 1; i < plain_tree.nodes.size(); ++i) {
    const NodeId n = tree_.nodes()[i];
    for (const Dart d : all_darts(tree_.mesh(n))) {
      const Dart up = tree_.to_parent(n, d);
      ASSERT_TRUE(tree_.mesh(tree_.parent(n)).is_dart(up));
      const auto from = leading(tree_.mesh(n), d, dimension(n));
      const auto to = leading(tree_.mesh(tree_.parent(n)), up, dimension(n));
      for (std::size_t v = 0; v < from.size(); ++v)
        EXPECT_EQ(to[v], static_cast<Index>(plain_tree.nodes[i].image.at(static_cast<int>(from[v]))));
    }
  }
}

TEST_P(Queries, CommuteWithSwitchesInsideAFacet) {
  for (const NodeId n : tree_.nodes().subspan(1)) {
    const Mesh &below = tree_.mesh(n), &above = tree_.mesh(tree_.parent(n));
    for (const Dart d : all_darts(below))
      for (int k = 0; k < below.dimension(); ++k)
        EXPECT_EQ(tree_.to_parent(n, below.switch_dart(d, k)), above.switch_dart(tree_.to_parent(n, d), k));
  }
}

TEST_P(Queries, FindAllPreimagesOnceInEveryMeshBelow) {
  const oracle::Tree plain_tree = oracle_tree(tree_);
  for (std::size_t i = 0; i < plain_tree.nodes.size(); ++i) {
    const NodeId above = tree_.nodes()[i];
    for (const NodeId below : tree_.descendants(above)) {
      const auto j = static_cast<int>(std::find(tree_.nodes().begin(), tree_.nodes().end(), below) -
                                      tree_.nodes().begin());
      for (int k = 0; k <= dimension(above); ++k)
        for (const Dart d : some_darts(tree_.mesh(above))) {
          DartBuffer found{no_dart};  // results are appended
          tree_.to_descendant(above, d, k, below, found);
          oracle::SimplexSet got;
          for (std::size_t f = 1; f < found.size(); ++f) {
            got.push_back(as_simplex(leading(tree_.mesh(below), found[f], k)));
            const Dart back = tree_.to_ancestor(below, found[f], above);
            EXPECT_EQ(leading(tree_.mesh(above), back, k), leading(tree_.mesh(above), d, k)) << "in order";
          }
          const std::size_t with_repetitions = got.size();
          oracle::normalize(got);
          EXPECT_EQ(got.size(), with_repetitions);
          const auto s = as_simplex(leading(tree_.mesh(above), d, k));
          EXPECT_EQ(got, oracle::preimages(plain_tree, j, static_cast<int>(i), s));
          EXPECT_EQ(tree_.has_preimage(above, d, k, below), !got.empty());
        }
    }
  }
}

TEST_P(Queries, MapAcrossThroughTheRootOrTheLowestCommonAncestor) {
  const Mesh& root = tree_.mesh(NodeId::root);
  for (const NodeId from : tree_.nodes())
    for (const NodeId to : tree_.nodes())
      for (int k = 0; k <= std::min(dimension(from), dimension(to)); ++k)
        for (const Dart d : simplices_of(tree_.mesh(from), k)) {
          DartBuffer by_root, by_ancestor;
          tree_.map(from, d, k, to, MultiMesh::Via::root, by_root);
          tree_.map(from, d, k, to, MultiMesh::Via::lowest_common_ancestor, by_ancestor);
          std::set<Index> all, wanted;
          for (const Dart e : by_root) all.insert(tree_.mesh(to).simplex(e, k));
          for (const Dart e : simplices_of(tree_.mesh(to), k)) {
            const bool same =
                root.simplex(tree_.to_root(to, e), k) == root.simplex(tree_.to_root(from, d), k);
            if (same) wanted.insert(tree_.mesh(to).simplex(e, k));
            EXPECT_EQ(tree_.same_simplex(from, d, to, e, k), same);
          }
          EXPECT_EQ(all, wanted);
          for (const Dart e : by_ancestor) EXPECT_TRUE(all.contains(tree_.mesh(to).simplex(e, k)));
          if (from == to) {
            ASSERT_EQ(by_ancestor.size(), 1U);
            EXPECT_EQ(by_ancestor[0], d);
          }
        }
}

TEST_P(Queries, CopiesNameTheOneTheyLieOver) {
  for (const Dart e : simplices_of(tree_.mesh(NodeId::root), 1)) {
    Copies copies;
    copies.collect(tree_, e, 1);
    EXPECT_EQ(copies[0].dart, e);
    for (std::size_t i = 1; i < copies.size(); ++i) {
      const Copy &c = copies[i], &above = copies[c.above];
      ASSERT_LT(c.above, i);
      EXPECT_EQ(above.node, tree_.parent(c.node));
      EXPECT_EQ(leading(tree_.mesh(above.node), tree_.to_parent(c.node, c.dart), 1),
                leading(tree_.mesh(above.node), above.dart, 1));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RandomTrees, Queries, testing::Range(0U, 87U));

TEST(Map, OfASeamEdgeHasTwoPreimages) {
  Tree t = two_neighbors();
  const NodeId cut = add_cut_on_edge01(t, NodeId::root);
  DartBuffer found;
  t.tree->to_child(cut, edge(t, NodeId::root, 0, 1), 1, found);
  EXPECT_EQ(found.size(), 2U);
  found.clear();
  t.tree->to_child(cut, edge(t, NodeId::root, 0, 2), 1, found);
  EXPECT_EQ(found.size(), 1U);
  found.clear();
  t.tree->to_child(cut, edge(t, NodeId::root, 0, 2), 0, found);
  EXPECT_EQ(found.size(), 2U) << "vertex 0 lies on the seam";
}

// A grandchild's edge next to the seam: its other side is reached only through the root.
TEST(Map, CrossesASeamThroughTheRootOnly) {
  Tree t = two_neighbors();
  const NodeId cut = add_cut_on_edge01(t, NodeId::root);
  const NodeId left = add_drawn(t, cut, triangles({{0, 1, 2}}), {6, 3, 5});
  const Dart e = edge(t, left, 1, 2);  // root edge 1-0
  DartBuffer by_root, by_ancestor;
  t.tree->map(left, e, 1, cut, MultiMesh::Via::root, by_root);
  t.tree->map(left, e, 1, cut, MultiMesh::Via::lowest_common_ancestor, by_ancestor);
  EXPECT_EQ(by_root.size(), 2U);
  EXPECT_EQ(by_ancestor.size(), 1U);
}

TEST(Map, OfWhatIsNotCoveredIsEmpty) {
  Tree t = two_neighbors();
  const NodeId patch = add_drawn(t, NodeId::root, triangles({{0, 1, 2}}), {0, 2, 4});
  DartBuffer found;
  t.tree->to_child(patch, edge(t, NodeId::root, 3, 1), 2, found);
  t.tree->to_child(patch, edge(t, NodeId::root, 3, 1), 1, found);
  t.tree->to_child(patch, edge(t, NodeId::root, 3, 1), 0, found);
  EXPECT_TRUE(found.empty());
  EXPECT_EQ(t.tree->facet_over(patch, edge(t, NodeId::root, 3, 1)), no_index);
}

TEST(Map, FailsOnWhatIsNotInTheTree) {
  Tree t = two_neighbors();
  const NodeId child = add_cut_on_edge01(t, NodeId::root);
  DartBuffer out;
  EXPECT_THROW((void)t.tree->parent(NodeId::root), UsageError);
  EXPECT_THROW((void)t.tree->mesh(NodeId{7}), UsageError);
  EXPECT_THROW((void)t.tree->children(NodeId{7}), UsageError);
  EXPECT_THROW(t.tree->map(child, no_dart, 0, NodeId::root, MultiMesh::Via::root, out), UsageError);
  EXPECT_THROW(t.tree->map(NodeId{7}, Dart{0}, 0, child, MultiMesh::Via::root, out), UsageError);
  EXPECT_THROW(t.tree->map(child, t.tree->mesh(child).dart_of(2, 0), 0, NodeId{7}, MultiMesh::Via::root, out),
               UsageError);
  EXPECT_THROW(t.tree->require_dart(NodeId::root, Dart{100000}), UsageError);
}

/// Every query of the tree with this node and dart, named.
std::vector<std::pair<std::string, std::function<void()>>> queries(const MultiMesh& tree, NodeId n, Dart d,
                                                                   int k, NodeId other, DartBuffer& out) {
  using Via = MultiMesh::Via;
  return {
      {"to_child", [&, n, d, k] { tree.to_child(n, d, k, out); }},
      {"to_parent", [&, n, d] { (void)tree.to_parent(n, d); }},
      {"to_root", [&, n, d] { (void)tree.to_root(n, d); }},
      {"to_ancestor", [&, n, d, other] { (void)tree.to_ancestor(n, d, other); }},
      {"facet_over", [&, n, d] { (void)tree.facet_over(n, d); }},
      {"facet_copy", [&, n, d] { (void)tree.facet_copy(n, d); }},
      {"has_preimage", [&, n, d, k, other] { (void)tree.has_preimage(other, d, k, n); }},
      {"to_descendant", [&, n, d, k, other] { tree.to_descendant(other, d, k, n, out); }},
      {"anchor", [&, n, d] { (void)tree.anchor(n, code(d)); }},
      {"map", [&, n, d, k, other] { tree.map(n, d, k, other, Via::root, out); }},
      {"map down", [&, n, d, k, other] { tree.map(other, d, k, n, Via::lowest_common_ancestor, out); }},
      {"same_simplex", [&, n, d, k, other] { (void)tree.same_simplex(n, d, other, d, k); }},
      {"parent", [&, n] { (void)tree.parent(n); }},
      {"lowest_common_ancestor", [&, n, other] { (void)tree.lowest_common_ancestor(n, other); }},
  };
}

void expect_refused(const MultiMesh& tree, NodeId n, Dart d, int k, NodeId other,
                    std::initializer_list<const char*> but = {}) {
  DartBuffer out;
  for (const auto& [name, query] : queries(tree, n, d, k, other, out)) {
    const bool checks_less = std::any_of(but.begin(), but.end(), [&](const char* b) { return name == b; });
    if (!checks_less) {
      EXPECT_THROW(query(), UsageError) << name;
    }
  }
  EXPECT_TRUE(out.empty());
}

constexpr std::initializer_list<const char*> by_node_only = {"parent", "lowest_common_ancestor"};

TEST(QueriesOfTheTree, RefuseNodesThatAreNotInTheTree) {
  Tree t = two_neighbors();
  add_cut_on_edge01(t, NodeId::root);
  const Dart d = t.tree->mesh(NodeId::root).dart_of(2, 0);
  expect_refused(*t.tree, NodeId{7}, d, 0, NodeId::root);
}

TEST(QueriesOfTheTree, RefuseTheRootWhereAChildIsMeant) {
  Tree t = two_neighbors();
  const Dart d = t.tree->mesh(NodeId::root).dart_of(2, 0);
  DartBuffer out;
  EXPECT_THROW(t.tree->to_child(NodeId::root, d, 0, out), UsageError);
  EXPECT_THROW((void)t.tree->to_parent(NodeId::root, d), UsageError);
  EXPECT_THROW((void)t.tree->facet_over(NodeId::root, d), UsageError);
  EXPECT_THROW((void)t.tree->facet_copy(NodeId::root, d), UsageError);
  EXPECT_THROW((void)t.tree->anchor(NodeId::root, 0), UsageError);
}

TEST(QueriesOfTheTree, RefuseDartsThatAreNotAlive) {
  Tree t = two_neighbors_plus_one();
  const NodeId cut = add_cut_on_edge01(t, NodeId::root);
  const Dart dying = edge(t, NodeId::root, 0, 4);
  const Dart dead_below = t.tree->facet_copy(cut, dying);
  ASSERT_TRUE(t.operations->collapse(NodeId::root, dying));
  ASSERT_FALSE(t.tree->mesh(NodeId::root).is_dart(dying));
  for (const Dart d : {no_dart, Dart{12345}}) expect_refused(*t.tree, cut, d, 0, NodeId::root, by_node_only);
  DartBuffer out;
  EXPECT_THROW(t.tree->to_child(cut, dying, 0, out), UsageError);
  EXPECT_THROW(t.tree->to_descendant(NodeId::root, dying, 0, cut, out), UsageError);
  EXPECT_THROW((void)t.tree->has_preimage(NodeId::root, dying, 0, cut), UsageError);
  EXPECT_THROW((void)t.tree->facet_over(cut, dying), UsageError);
  EXPECT_THROW((void)t.tree->facet_copy(cut, dying), UsageError);
  EXPECT_THROW((void)t.tree->to_parent(cut, dead_below), UsageError);
  EXPECT_THROW((void)t.tree->to_root(cut, dead_below), UsageError);
  EXPECT_TRUE(out.empty());
}

TEST(QueriesOfTheTree, RefuseDimensionsThatTheMeshHasNot) {
  Tree t = two_neighbors();
  const NodeId cut = add_cut_on_edge01(t, NodeId::root);
  const Dart d = t.tree->mesh(NodeId::root).dart_of(2, 0);
  DartBuffer out;
  for (const int k : {-1, 3, 7}) {
    EXPECT_THROW(t.tree->to_child(cut, d, k, out), UsageError);
    EXPECT_THROW(t.tree->to_descendant(NodeId::root, d, k, cut, out), UsageError);
    EXPECT_THROW((void)t.tree->has_preimage(NodeId::root, d, k, cut), UsageError);
    EXPECT_THROW(t.tree->map(NodeId::root, d, k, cut, MultiMesh::Via::root, out), UsageError);
    EXPECT_THROW((void)t.tree->same_simplex(NodeId::root, d, NodeId::root, d, k), UsageError);
  }
  EXPECT_TRUE(out.empty());
}

TEST(QueriesOfTheTree, RefuseMeshesThatAreNotAboveOrBelow) {
  Tree t = two_neighbors();
  const NodeId one = add_cut_on_edge01(t, NodeId::root), two = add_cut_on_edge01(t, NodeId::root);
  const Dart d = t.tree->mesh(one).dart_of(2, 0);
  DartBuffer out;
  EXPECT_THROW((void)t.tree->to_ancestor(one, d, two), UsageError);
  EXPECT_THROW(t.tree->to_descendant(one, d, 0, two, out), UsageError);
  EXPECT_THROW((void)t.tree->has_preimage(one, d, 0, two), UsageError);
  EXPECT_TRUE(t.tree->has_preimage(one, d, 0, one));
}

TEST(QueriesOfTheTree, FindNoCopiesInMeshesThatAreNotThere) {
  Tree t = two_neighbors();
  ASSERT_TRUE(t.operations->split(NodeId::root, edge(t, NodeId::root, 0, 1)));
  EXPECT_TRUE(t.operations->copies().of(NodeId{7}).empty());
  EXPECT_EQ(t.operations->copies().of(NodeId::root).size(), 1U);
}

}  // namespace
}  // namespace multimesh::test
