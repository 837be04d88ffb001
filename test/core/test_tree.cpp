// SPDX-License-Identifier: BSD-3-Clause
// The tree itself: building it, refusing bad maps, names of nodes, taking it apart.
#include <gtest/gtest.h>

#include <set>

#include "multimesh/openmesh/make_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/support/fingerprint.hpp"

namespace multimesh::test {
namespace {

std::vector<Anchor> identity_anchors(const Mesh& child, const Mesh& parent) {
  std::vector<Anchor> anchors;
  for (Index f = 0; f < child.capacity(2); ++f) {
    Index v[4];
    child.vertices(child.dart_of(2, f), v);
    anchors.push_back({child.dart_of(2, f), dart_with(parent, f, v)});
  }
  return anchors;
}

class AddChild : public testing::Test {
 protected:
  AddChild()
      : t_(two_neighbors()), child_(openmesh::make_mesh(triangles({{0, 1, 2}, {3, 1, 0}, {0, 2, 4}}))) {
    anchors_ = identity_anchors(*child_, t_.tree->mesh(NodeId::root));
  }
  void expect_refused(const std::string& named) {
    const auto before = fingerprint(t_);
    try {
      (void)t_.tree->add_child(NodeId::root, std::move(child_), anchors_);
      FAIL() << "accepted";
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(named), std::string::npos) << e.what();
    }
    EXPECT_EQ(fingerprint(t_), before);
    EXPECT_EQ(t_.tree->nodes().size(), 1U);
    EXPECT_TRUE(t_.tree->children(NodeId::root).empty());
  }
  Tree t_;
  std::unique_ptr<Mesh> child_;
  std::vector<Anchor> anchors_;
};

TEST_F(AddChild, StoresTheAnchorsInBothDirections) {
  const NodeId n = t_.tree->add_child(NodeId::root, std::move(child_), anchors_);
  EXPECT_EQ(validate(*t_.tree), std::vector<std::string>{});
  for (Index f = 0; f < 3; ++f) {
    EXPECT_EQ(t_.tree->anchor(n, f), anchors_[f]);
    EXPECT_EQ(t_.tree->facet_over(n, anchors_[f].parent), f);
  }
}

TEST_F(AddChild, RefusesAMissingAnchor) {
  anchors_.pop_back();
  expect_refused("facet 2");
}

TEST_F(AddChild, RefusesAnAnchorOfAnotherFacet) {
  std::swap(anchors_[0].own, anchors_[1].own);
  expect_refused("facet 0");
}

TEST_F(AddChild, RefusesADeadParentDart) {
  anchors_[1].parent = no_dart;
  expect_refused("facet 1");
}

TEST_F(AddChild, RefusesTwoFacetsOverOne) {
  anchors_[2].parent = anchors_[0].parent;
  expect_refused("facet 2");
}

TEST_F(AddChild, RefusesAMapThatIsNotSimplicial) {
  anchors_[1].parent = t_.tree->mesh(NodeId::root).reorder(anchors_[1].parent, permutation(1, 0));
  expect_refused("two images");
}

TEST(AddChildOfHigherDimension, IsRefused) {
  Tree t = drawn({{0, 1, 2}});
  const NodeId sides = t.add_boundary(NodeId::root);
  auto child = openmesh::make_mesh(triangles({{0, 1, 2}}));
  const std::vector<Anchor> anchors{{child->dart_of(2, 0), t.tree->mesh(sides).dart_of(1, 0)}};
  EXPECT_THROW((void)t.tree->add_child(sides, std::move(child), anchors), InputError);
  EXPECT_THROW((void)add_child_by_facets(*t.tree, sides, triangles({{0, 1, 2}}), triangles({{1, 2, 0}}),
                                         std::vector<Index>{0}, openmesh::make_mesh),
               InputError);
}

TEST(AddChildByFacets, NamesTheFacetThatDoesNotCorrespond) {
  Tree t = two_neighbors();
  const FacetList child = triangles({{0, 1, 2}, {0, 2, 3}});
  const auto add = [&](const FacetList& over, std::vector<Index> facets) {
    try {
      (void)add_child_by_facets(*t.tree, NodeId::root, child, over, facets, openmesh::make_mesh);
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(add(triangles({{0, 1, 2}, {0, 2, 3}}), {0, 2}).find("facet 1"), std::string::npos);
  EXPECT_NE(add(triangles({{0, 1, 2}, {0, 2, 4}}), {0, 9}).find("facet 1"), std::string::npos);
  EXPECT_NE(add(triangles({{0, 1, 2}}), {0}), "");
  EXPECT_NE(add(triangles({{0, 1, 2}, {2, 0, 4}}), {0, 2}), "") << "not in corresponding order";
  EXPECT_EQ(t.tree->nodes().size(), 1U);
  EXPECT_EQ(add(triangles({{0, 1, 2}, {0, 2, 4}}), {0, 2}), "");
}

TEST(AddChild_, RefusesNothingAndMissingParents) {
  Tree t = two_neighbors();
  EXPECT_THROW((void)t.tree->add_child(NodeId::root, nullptr, {}), UsageError);
  EXPECT_THROW((void)t.tree->add_child(NodeId{3}, openmesh::make_mesh(triangles({{0, 1, 2}})), {}),
               UsageError);
  EXPECT_THROW(MultiMesh(nullptr), UsageError);
}

NodeId add_copy(Tree& t, NodeId parent) {
  return add_drawn(t, parent, triangles({{0, 1, 2}, {3, 1, 0}, {0, 2, 4}}), {0, 1, 2, 3, 4});
}

//            root
//          /      \           ten meshes, depth 4
//         a        b
//       / | \      |
//      c  d  e     f
//         |        |
//         g        h
//         |
//         i
struct Family {
  Tree t = two_neighbors();
  NodeId a = add_copy(t, NodeId::root), b = add_copy(t, NodeId::root);
  NodeId c = add_copy(t, a), d = add_copy(t, a), e = add_copy(t, a), f = add_copy(t, b);
  NodeId g = add_copy(t, d), h = add_copy(t, f), i = add_copy(t, g);
};

std::set<NodeId> set_of(std::span<const NodeId> nodes) {
  return {nodes.begin(), nodes.end()};
}

TEST(TreeOfMeshes, KnowsWhoIsBelowWhom) {
  const Family x;
  const MultiMesh& tree = *x.t.tree;
  EXPECT_EQ(tree.nodes().size(), 10U);
  EXPECT_EQ(tree.depth(x.i), 4);
  EXPECT_EQ(tree.depth(NodeId::root), 0);
  EXPECT_EQ(tree.parent(x.g), x.d);
  EXPECT_EQ(set_of(tree.children(x.a)), (std::set{x.c, x.d, x.e}));
  EXPECT_EQ(set_of(tree.descendants(x.a)), (std::set{x.c, x.d, x.e, x.g, x.i}));
  EXPECT_EQ(tree.descendants(NodeId::root).size(), 9U);
  EXPECT_EQ(tree.lowest_common_ancestor(x.i, x.e), x.a);
  EXPECT_EQ(tree.lowest_common_ancestor(x.h, x.i), NodeId::root);
  EXPECT_EQ(tree.lowest_common_ancestor(x.d, x.i), x.d);
  EXPECT_EQ(tree.lowest_common_ancestor(x.d, x.d), x.d);
  std::set<NodeId> seen;
  for (const NodeId n : tree.nodes()) {
    EXPECT_TRUE(n == NodeId::root || seen.contains(tree.parent(n))) << "parents first";
    seen.insert(n);
  }
}

TEST(TreeOfMeshes, MovesAllMeshesTogether) {
  Family x;
  ASSERT_TRUE(x.t.operations->split(x.i, edge(x.t, x.i, 0, 1)));
  ASSERT_TRUE(x.t.operations->swap(x.h, edge(x.t, x.h, 0, 2)));
  EXPECT_EQ(validate(*x.t.tree), std::vector<std::string>{});
  for (const NodeId n : x.t.tree->nodes())
    EXPECT_EQ(sorted_facets(x.t.tree->mesh(n)), sorted_facets(x.t.tree->mesh(NodeId::root)));
}

TEST(Detach, TakesEverythingBelowAlong) {
  Family x;
  const Mesh* mesh_of_g = &x.t.tree->mesh(x.g);
  const MultiMesh other = x.t.tree->detach(x.d);
  EXPECT_EQ(validate(*x.t.tree), std::vector<std::string>{});
  EXPECT_EQ(validate(other), std::vector<std::string>{});
  EXPECT_EQ(x.t.tree->nodes().size(), 7U);
  ASSERT_EQ(other.nodes().size(), 3U);
  EXPECT_EQ(&other.mesh(other.nodes()[1]), mesh_of_g);
  EXPECT_EQ(other.depth(other.nodes()[2]), 2);
  for (const NodeId gone : {x.d, x.g, x.i}) EXPECT_FALSE(x.t.tree->contains(gone));
  for (const NodeId here : {x.a, x.c, x.e, x.h}) EXPECT_TRUE(x.t.tree->contains(here));
  EXPECT_EQ(set_of(x.t.tree->children(x.a)), (std::set{x.c, x.e}));
}

TEST(Detach, LeavesBothTreesUsable) {
  Family x;
  MultiMesh other = x.t.tree->detach(x.a);
  Propagation mine(*x.t.tree), theirs(other);
  ASSERT_TRUE(mine.split(x.h, find_dart(x.t.tree->mesh(x.h), {0, 1})));
  ASSERT_TRUE(theirs.collapse(NodeId::root, find_dart(other.mesh(NodeId::root), {3, 1})));
  EXPECT_EQ(validate(*x.t.tree), std::vector<std::string>{});
  EXPECT_EQ(validate(other), std::vector<std::string>{});
  EXPECT_EQ(sorted_facets(x.t.tree->mesh(x.f)).size(), 5U);
  EXPECT_EQ(sorted_facets(other.mesh(other.nodes()[2])).size(), 2U);
  x.t.tree->compact();
  other.compact();
  EXPECT_EQ(validate(*x.t.tree), std::vector<std::string>{});
  EXPECT_EQ(validate(other), std::vector<std::string>{});
}

TEST(Detach, FreesTheNameForNobodyElse) {
  Family x;
  (void)x.t.tree->detach(x.c);
  const NodeId fresh = add_child_from_boundary(*x.t.tree, x.e, openmesh::make_mesh);
  EXPECT_NE(fresh, x.c);
  EXPECT_EQ(validate(*x.t.tree), std::vector<std::string>{});
  EXPECT_THROW((void)x.t.tree->detach(NodeId::root), UsageError);
  EXPECT_THROW((void)x.t.tree->detach(x.c), UsageError);
}

TEST(TreeInATransaction, CannotBeRebuilt) {
  Tree t = two_neighbors();
  const NodeId n = add_copy(t, NodeId::root);
  const Transaction open(*t.tree, {});
  EXPECT_THROW((void)t.tree->compact(), UsageError);
  EXPECT_THROW((void)t.tree->detach(n), UsageError);
  EXPECT_THROW((void)add_copy(t, NodeId::root), UsageError);
}

}  // namespace
}  // namespace multimesh::test
