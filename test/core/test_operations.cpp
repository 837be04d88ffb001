// SPDX-License-Identifier: BSD-3-Clause
// Every operation on every edge of every mesh of many trees. Each is tried in a transaction that is not
// committed, so that the next one finds the tree as it was.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "multimesh/validate.hpp"
#include "oracle/collapse.hpp"
#include "oracle/split.hpp"
#include "test/core/drawn.hpp"
#include "test/support/fingerprint.hpp"
#include "test/support/topology.hpp"

namespace multimesh::test {
namespace {

std::unique_ptr<Tree> own(Tree t) {
  return std::make_unique<Tree>(std::move(t));
}

/// The kinds of the random tests, hand-made trees, and trees of the oracle's generator.
std::vector<TreeKind> all_trees() {
  std::vector<TreeKind> all;
  for (const TreeKind& kind : tree_kinds())
    for (unsigned seed = 0; seed < (kind.name == "Torus3Tile" ? 1 : 2); ++seed)
      all.push_back({kind.name + std::to_string(seed), [=](Index, unsigned) { return kind.make(16, seed); }});
  all.push_back({"DiskToIndividual", [](Index, unsigned) { return own(disk_to_individual(5)); }});
  all.push_back(
      {"CutOnOneEdge", [](Index, unsigned) {
         auto t = own(two_neighbors_plus_one());
         add_drawn(*t, NodeId::root, triangles({{0, 1, 2}, {6, 3, 5}, {0, 2, 4}}), {0, 1, 2, 1, 4, 0, 3});
         return t;
       }});
  for (unsigned seed = 0; seed < 30; ++seed)
    all.push_back(
        {"Random" + std::to_string(seed), [=](Index, unsigned) { return random_small_tree(seed, 12); }});
  for (unsigned seed = 0; seed < 18; ++seed)
    all.push_back({"RandomSolid" + std::to_string(seed),
                   [=](Index, unsigned) { return random_small_solid_tree(seed, 12); }});
  return all;
}

class Operations : public testing::TestWithParam<TreeKind> {
 protected:
  Operations() : owner_(GetParam().make(16, 0)), tree_(*owner_->tree), ops_(*owner_->operations) {}

  /// test(node, edge dart) on every edge, in both directions.
  template <class Test>
  void on_every_edge(const Test& test) {
    for (const NodeId n : tree_.nodes()) {
      const DartBuffer edges = simplices_of(tree_.mesh(n), 1);
      const std::size_t step = edges.size() / 150 + 1;  // all of them, if not many
      for (std::size_t i = 0; i < edges.size(); i += step)
        for (const Dart e : {edges[i], tree_.mesh(n).switch_dart(edges[i], 0)}) {
          SCOPED_TRACE("mesh " + std::to_string(index(n)) + ", dart " + std::to_string(code(e)));
          const auto before = fingerprint(*owner_);
          {
            const Transaction undone(tree_, attributes());
            test(n, e);
            ASSERT_EQ(validate(tree_), std::vector<std::string>{});
            ASSERT_EQ(stray_vertex(), "");
          }
          ASSERT_EQ(fingerprint(*owner_), before);
        }
    }
  }
  bool is_solid() const { return tree_.mesh(NodeId::root).dimension() == 3; }

  std::vector<Attribute*> attribute_list_;
  std::span<Attribute* const> attributes() {
    attribute_list_.clear();
    for (const NodeId n : tree_.nodes()) attribute_list_.push_back(&owner_->attribute(n));
    return attribute_list_;
  }

  /// A vertex whose position is not that of its image.
  std::string stray_vertex() const {
    for (const NodeId n : tree_.nodes().subspan(1))
      for (const Dart v : simplices_of(tree_.mesh(n), 0)) {
        const Index up = tree_.mesh(tree_.parent(n)).vertex(tree_.to_parent(n, v));
        if (owner_->points(n)[tree_.mesh(n).vertex(v)] != owner_->points(tree_.parent(n))[up])
          return "vertex " + std::to_string(tree_.mesh(n).vertex(v)) + " of mesh " + std::to_string(index(n));
      }
    return {};
  }

  std::vector<Topology> topologies() const {
    std::vector<Topology> all;
    for (const NodeId n : tree_.nodes()) all.push_back(topology(tree_.mesh(n)));
    return all;
  }

  std::array<Index, 2> ends(NodeId n, Dart e) const {
    Index v[4];
    tree_.mesh(n).vertices(e, v);
    return {v[0], v[1]};
  }

  std::unique_ptr<Tree> owner_;
  MultiMesh& tree_;
  Propagation& ops_;
};

TEST_P(Operations, SplitIsThatOfTheVertexSets) {
  on_every_edge([&](NodeId n, Dart e) {
    const auto old = oracle_tree(tree_);
    const auto copies = edge_copies(tree_, tree_.to_root(n, e));
    const auto [a, b] = ends(n, e);
    const Outcome o = ops_.split(n, e, 0.25);
    ASSERT_TRUE(o);
    const auto wanted = oracle::split(old, copies[0].a, copies[0].b);
    std::vector<std::map<int, int>> names(old.nodes.size());
    ASSERT_EQ(ops_.copies().size(), copies.size());
    for (std::size_t i = 0; i < copies.size(); ++i) {
      const Copy& c = ops_.copies()[i];
      const auto [at, fresh] = ends(c.node, c.dart);
      EXPECT_EQ(static_cast<int>(at), copies[i].a);
      names[copies[i].node][static_cast<int>(fresh)] =
          wanted.vertex[copies[i].node].at(oracle::simplex({copies[i].a, copies[i].b}));
    }
    EXPECT_EQ(plain(oracle_tree(tree_), names), plain(wanted.tree));
    EXPECT_EQ(ends(n, o.dart)[0], a) << "(a, c, ...)";
    EXPECT_NE(ends(n, o.dart)[1], b);
    EXPECT_EQ(ends(NodeId::root, o.root), ends(NodeId::root, tree_.to_root(n, o.dart)));
  });
}

TEST_P(Operations, CollapseIsThatOfTheVertexSets) {
  on_every_edge([&](NodeId n, Dart e) {
    const auto old = oracle_tree(tree_);
    const auto was = topologies();
    const auto copies = edge_copies(tree_, tree_.to_root(n, e));
    const auto [a, b] = ends(n, e);
    const CollapseVerdict verdict = ops_.judge(n, e);
    const Outcome o = ops_.collapse(n, e);
    // The second of two copies in one mesh is judged again.
    EXPECT_TRUE(verdict.refusal.check == o.refusal.check || o.refusal.check == Check::link_condition);
    if (!o) return;
    EXPECT_EQ(topologies(), was);
    const auto wanted = oracle::collapse(old, copies[0].a, copies[0].b);
    ASSERT_TRUE(wanted.valid) << wanted.reason;
    EXPECT_EQ(plain(oracle_tree(tree_), wanted.merged), plain(wanted.tree));
    const Index merged = ends(n, o.dart)[0];
    EXPECT_TRUE(merged == a || merged == b);
    EXPECT_EQ(tree_.mesh(NodeId::root).vertex(tree_.to_root(n, o.dart)),
              tree_.mesh(NodeId::root).vertex(o.root));
  });
}

TEST_P(Operations, AnAcceptedSwapReplacesTheDiagonalInEveryMesh) {
  if (is_solid()) return;
  on_every_edge([&](NodeId n, Dart e) {
    const auto was = topologies();
    const auto [a, b] = ends(n, e);
    const auto old = oracle_tree(tree_);
    const Outcome o = ops_.swap(n, e);
    if (!o) {
      EXPECT_EQ(o.refusal.check, Check::flip);
      return;
    }
    EXPECT_EQ(topologies(), was);
    const auto [l, r] = ends(n, o.dart);
    EXPECT_EQ(find_dart(tree_.mesh(n), {a, b}), no_dart);
    EXPECT_NE(find_dart(tree_.mesh(n), {a, l, r}), no_dart);
    EXPECT_NE(find_dart(tree_.mesh(n), {b, l, r}), no_dart);
    EXPECT_EQ(ends(NodeId::root, o.root), ends(NodeId::root, tree_.to_root(n, o.dart)));
    const Outcome back = ops_.swap(n, o.dart);
    ASSERT_TRUE(back);
    EXPECT_EQ(plain(oracle_tree(tree_)), plain(old)) << "twice is nothing";
    EXPECT_EQ(oracle::simplex({int(ends(n, back.dart)[0]), int(ends(n, back.dart)[1])}),
              oracle::simplex({int(a), int(b)}));
  });
}

TEST_P(Operations, AnAcceptedSwapInASolidJoinsAnApexToTheOthers) {
  if (!is_solid()) return;
  on_every_edge([&](NodeId n, Dart e) {
    const auto was = topologies();
    const Mesh& root = tree_.mesh(NodeId::root);
    Index v[4];
    root.vertices(tree_.to_root(n, e), v);
    const Index a = v[0], b = v[1], x = v[2];
    DartBuffer around;
    root.star(tree_.to_root(n, e), 1, around);
    std::set<Index> rim;
    for (const Dart t : around) {
      root.vertices(t, v);
      rim.insert({v[2], v[3]});
    }
    const auto old = oracle_tree(tree_);
    // A surface on the edge follows it, but not the face that takes its place.
    bool in_solids = true;
    for (const EdgeCopy& c : edge_copies(tree_, tree_.to_root(n, e)))
      in_solids = in_solids && tree_.mesh(tree_.nodes()[c.node]).dimension() == 3;
    const Outcome o = ops_.swap(n, e);
    if (!o) return;
    EXPECT_EQ(topologies(), was);
    EXPECT_EQ(find_dart(root, {a, b}), no_dart);
    EXPECT_EQ(root.vertex(o.root), x);
    if (in_solids && around.size() == 3) {  // (a,b) became the face of the rim
      ASSERT_EQ(rim.size(), 3U);
      const Dart face = find_dart(root, std::vector<Index>(rim.begin(), rim.end()));
      ASSERT_NE(face, no_dart);
      ASSERT_TRUE(ops_.swap_face(NodeId::root, face));
      EXPECT_EQ(plain(oracle_tree(tree_)), plain(old)) << "3-2, then 2-3";
    }
  });
}

TEST_P(Operations, AnAcceptedSwapOfAFaceIsUndoneByOneOfItsEdge) {
  if (!is_solid()) return;
  const Mesh& root = tree_.mesh(NodeId::root);
  std::size_t step = 0;
  for (const Dart f : simplices_of(root, 2)) {
    if (step++ % (root.capacity(3) / 60 + 1) != 0) continue;
    SCOPED_TRACE("face dart " + std::to_string(code(f)));
    const auto before = fingerprint(*owner_);
    {
      const Transaction undone(tree_, attributes());
      const auto old = oracle_tree(tree_);
      const auto was = topologies();
      if (const Outcome o = ops_.swap_face(NodeId::root, f)) {
        EXPECT_EQ(validate(tree_), std::vector<std::string>{});
        EXPECT_EQ(topologies(), was);
        DartBuffer around;
        root.star(o.dart, 1, around);
        EXPECT_EQ(around.size(), 3U);
        ASSERT_TRUE(ops_.swap(NodeId::root, o.dart));
        EXPECT_EQ(plain(oracle_tree(tree_)), plain(old)) << "2-3, then 3-2";
      }
    }
    ASSERT_EQ(fingerprint(*owner_), before);
  }
}

TEST_P(Operations, CollapseOfANewVertexUndoesItsInsertion) {
  on_every_edge([&](NodeId n, Dart d) {
    const Mesh& mesh = tree_.mesh(n);
    for (int k = 1; k <= mesh.dimension(); ++k) {
      const Transaction undone(tree_, attributes());
      const auto old = oracle_tree(tree_);
      Index corners[4];
      mesh.vertices(d, corners);
      const Outcome inside = ops_.split_simplex(n, d, k);
      ASSERT_TRUE(inside) << k;
      ASSERT_EQ(validate(tree_), std::vector<std::string>{}) << k;
      ASSERT_EQ(stray_vertex(), "");
      const Index m = mesh.vertex(inside.dart);
      const Dart back = find_dart(mesh, {m, corners[0]});
      ASSERT_NE(back, no_dart) << k;
      ASSERT_TRUE(ops_.collapse(n, back, Placement::keep_b())) << k;
      EXPECT_EQ(plain(oracle_tree(tree_)), plain(old)) << k;
    }
  });
}

TEST_P(Operations, CollapseOfTheNewEdgeUndoesASplit) {
  for (const Placement back : {Placement::keep_b(), Placement::keep_a()})
    on_every_edge([&](NodeId n, Dart e) {
      const auto old = oracle_tree(tree_);
      const Outcome cut = ops_.split(n, e);
      ASSERT_TRUE(cut);
      // (a, c): the new vertex c goes into a.
      const Mesh& mesh = tree_.mesh(n);
      const Dart new_edge = back.t > 0 ? mesh.switch_dart(cut.dart, 0) : cut.dart;
      ASSERT_TRUE(ops_.collapse(n, new_edge, back));
      EXPECT_EQ(plain(oracle_tree(tree_)), plain(old));
    });
}

TEST_P(Operations, RelocationMovesAllCopiesOfAVertex) {
  const Point3 to(3, 4, 5);
  on_every_edge([&](NodeId n, Dart v) {
    ASSERT_TRUE(ops_.relocate(n, v, [&](const Event& event) {
      EXPECT_EQ(event.operation, Operation::relocate);
      for (const Copy& c : event.copies.all())
        owner_->attribute(c.node).set(event.tree.mesh(c.node).vertex(c.dart), to);
    }));
    EXPECT_EQ(owner_->points(n)[tree_.mesh(n).vertex(v)], to);
    EXPECT_EQ(ops_.copies()[0].node, NodeId::root);
  });
}

INSTANTIATE_TEST_SUITE_P(Trees, Operations, testing::ValuesIn(all_trees()),
                         [](const auto& kind) { return kind.param.name; });

TEST(Operations_, RefuseDeadDartsAndMissingMeshesAsUsageErrors) {
  Tree t = two_neighbors();
  const Dart e = edge(t, NodeId::root, 3, 1);
  ASSERT_TRUE(t.operations->collapse(NodeId::root, e));
  const auto before = fingerprint(t);
  EXPECT_THROW((void)t.operations->split(NodeId::root, e), UsageError);
  EXPECT_THROW((void)t.operations->collapse(NodeId::root, e), UsageError);
  EXPECT_THROW((void)t.operations->swap(NodeId::root, e), UsageError);
  EXPECT_THROW((void)t.operations->judge(NodeId::root, e), UsageError);
  EXPECT_THROW((void)t.operations->split(NodeId{4}, Dart{0}), UsageError);
  EXPECT_THROW((void)t.operations->relocate(NodeId::root, no_dart, [](const Event&) {}), UsageError);
  EXPECT_EQ(fingerprint(t), before);
}

TEST(Statistics_, CountEveryAnswerOnce) {
  Tree t = two_neighbors();
  Propagation& ops = *t.operations;
  ASSERT_TRUE(ops.split(NodeId::root, edge(t, NodeId::root, 0, 1)));
  ASSERT_FALSE(ops.swap(NodeId::root, edge(t, NodeId::root, 0, 4)));
  ASSERT_FALSE(ops.swap_by_split_and_collapse(NodeId::root, edge(t, NodeId::root, 0, 4)));
  ASSERT_TRUE(ops.swap_by_split_and_collapse(NodeId::root, edge(t, NodeId::root, 0, 2)));
  FunctionInvariant never("never", [](const Event&) { return false; });
  ops.add(never);
  const Outcome o = ops.collapse(NodeId::root, edge(t, NodeId::root, 3, 5));
  EXPECT_EQ(o.refusal.check, Check::invariant);
  EXPECT_EQ(o.refusal.invariant, "never");
  EXPECT_EQ(o.dart, no_dart);
  EXPECT_EQ(o.root, no_dart);
  EXPECT_EQ(ops.statistics().tried, 5U);
  EXPECT_EQ(ops.statistics().done, 2U);
  EXPECT_EQ(ops.statistics().refused_by(Check::flip), 2U);
  EXPECT_EQ(ops.statistics().refused_by(Check::invariant), 1U);
}

}  // namespace
}  // namespace multimesh::test
