// SPDX-License-Identifier: BSD-3-Clause
// Transactions in transactions, and the user's own properties under operations.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <memory>

#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/core/user_values.hpp"
#include "test/support/fingerprint.hpp"

namespace multimesh::test {
namespace {

std::unique_ptr<Tree> fan() {
  auto t = std::make_unique<Tree>(disk_to_individual(6));
  t->add_boundary(NodeId{1});
  return t;
}

std::unique_ptr<Tree> of_kind(const char* name) {
  for (const TreeKind& kind : tree_kinds())
    if (kind.name == name) return kind.make(24, 1);
  return nullptr;
}

struct NamedTree {
  std::string name;
  std::function<std::unique_ptr<Tree>()> make;
  friend void PrintTo(const NamedTree& t, std::ostream* out) { *out << t.name; }
};

class Transactions : public testing::TestWithParam<NamedTree> {
 protected:
  Transactions() : owner_(GetParam().make()), t_(*owner_) {
    for (const NodeId n : t_.tree->nodes()) {
      values_.emplace_back(t_.tree->mesh(n));
      attributes_.push_back(&t_.attribute(n));
    }
  }
  struct State {
    std::vector<std::uint64_t> words;
    std::vector<UserValues::All> values;
    friend bool operator==(const State&, const State&) = default;
  };
  State state() {
    State s{fingerprint(t_), {}};
    for (const UserValues& v : values_) s.values.push_back(v.all());
    return s;
  }
  Dart any(int i) const {
    const DartBuffer darts = all_darts(t_.tree->mesh(NodeId::root));
    return darts[static_cast<std::size_t>(i) % darts.size()];
  }
  /// Splits, collapses and swaps, of which some are refused.
  void mix(int seed) {
    Propagation& o = *t_.operations;
    for (int i = 0; i < 12; ++i) {
      const Dart e = any(31 * i + seed);
      (void)(i % 5 == 0   ? o.split(NodeId::root, e)
             : i % 5 == 1 ? o.swap(NodeId::root, e)
             : i % 5 == 2 ? o.swap_face(NodeId::root, e)
             : i % 5 == 3 ? o.split_simplex(NodeId::root, e, 2)
                          : o.collapse(NodeId::root, e));
    }
    EXPECT_EQ(validate(*t_.tree), std::vector<std::string>{});
  }

  std::unique_ptr<Tree> owner_;
  Tree& t_;
  std::vector<UserValues> values_;
  std::vector<Attribute*> attributes_;
};

TEST_P(Transactions, AreUndoneAtTheEndOfTheirScope) {
  const State before = state();
  {
    const Transaction open(*t_.tree, attributes_);
    mix(1);
    EXPECT_NE(state(), before);
  }
  EXPECT_EQ(state(), before);
}

TEST_P(Transactions, AreKeptIfCommitted) {
  State after;
  {
    Transaction open(*t_.tree, attributes_);
    mix(1);
    after = state();
    open.commit();
  }
  EXPECT_EQ(state(), after);
  mix(2);
}

TEST_P(Transactions, CommittedInsideAreUndoneWithTheOuterOne) {
  const State before = state();
  {
    const Transaction outer(*t_.tree, attributes_);
    mix(1);
    {
      Transaction inner(*t_.tree, attributes_);
      mix(2);
      inner.commit();
    }
    mix(3);
  }
  EXPECT_EQ(state(), before);
}

TEST_P(Transactions, UndoneInsideLeaveWhatTheOuterOneDid) {
  Transaction outer(*t_.tree, attributes_);
  mix(1);
  const State between = state();
  {
    const Transaction inner(*t_.tree, attributes_);
    mix(2);
    EXPECT_NE(state(), between);
  }
  EXPECT_EQ(state(), between);
  outer.commit();
  EXPECT_EQ(state(), between);
  EXPECT_EQ(validate(*t_.tree), std::vector<std::string>{});
}

TEST_P(Transactions, ReplayToTheSameState) {
  State first;
  for (int round = 0; round < 3; ++round) {
    const Transaction open(*t_.tree, attributes_);
    mix(5);
    if (round == 0) first = state();
    EXPECT_EQ(state(), first) << "what is undone leaves no trace";
  }
}

TEST_P(Transactions, OfManyMeshesAndAttributesAreUndoneToo) {
  std::vector<std::vector<double>> more(9, std::vector<double>(200, 0.5));
  std::vector<std::unique_ptr<VertexAttribute<double>>> owners;
  for (auto& v : more) {
    owners.push_back(std::make_unique<VertexAttribute<double>>(NodeId::root, v));
    attributes_.push_back(owners.back().get());
  }
  ASSERT_GT(t_.tree->nodes().size() + attributes_.size(), 12U) << "more than are kept in place";
  const State before = state();
  {
    const Transaction open(*t_.tree, attributes_);
    mix(1);
    for (auto& o : owners) o->set(3, 7.0);
  }
  EXPECT_EQ(state(), before);
  for (const auto& v : more) EXPECT_EQ(v, std::vector<double>(200, 0.5));
}

TEST_P(Transactions, OfWritesToAnAttributeRestoreTheFirstValue) {
  const Point3 old = t_.points(NodeId::root)[0];
  {
    const Transaction open(*t_.tree, attributes_);
    t_.attribute(NodeId::root).set(0, Point3(7, 7, 7));
    t_.attribute(NodeId::root).set(0, Point3(8, 8, 8));
  }
  EXPECT_EQ(t_.points(NodeId::root)[0], old);
}

INSTANTIATE_TEST_SUITE_P(Trees, Transactions,
                         testing::Values(NamedTree{"Fan", fan},
                                         NamedTree{"SolidPart", [] { return of_kind("SolidPart"); }},
                                         NamedTree{"SolidCut", [] { return of_kind("SolidCut"); }},
                                         NamedTree{"SolidPoints", [] { return of_kind("SolidPoints"); }},
                                         NamedTree{"SolidFeatures", [] { return of_kind("SolidFeatures"); }}),
                         [](const auto& tree) { return tree.param.name; });

class TransactionsOfSurfaces : public Transactions {};
INSTANTIATE_TEST_SUITE_P(Trees, TransactionsOfSurfaces, testing::Values(NamedTree{"Fan", fan}));

/// For each node, what the user's values are before and after a split of a root edge.
TEST_P(TransactionsOfSurfaces, SplitCopiesTheUsersValuesToTheNewHalves) {
  const MultiMesh& tree = *t_.tree;
  const Dart e = edge(t_, NodeId::root, 0, 1);  // interior; two copies in the child, two in the curves
  std::vector<UserValues::All> before = state().values;
  std::vector<std::map<oracle::Simplex, Index>> facet_of, edge_of;
  const auto names = [&](int k) {
    std::vector<std::map<oracle::Simplex, Index>> all;
    for (const NodeId n : tree.nodes()) {
      auto& here = all.emplace_back();
      for (const Dart d : simplices_of(tree.mesh(n), std::min(k, tree.mesh(n).dimension()))) {
        Index v[4] = {};
        tree.mesh(n).vertices(d, v);
        const auto s = k == 1 || tree.mesh(n).dimension() == 1
                           ? oracle::simplex({int(v[0]), int(v[1])})
                           : oracle::simplex({int(v[0]), int(v[1]), int(v[2])});
        here[s] = tree.mesh(n).simplex(d, std::min(k, tree.mesh(n).dimension()));
      }
    }
    return all;
  };
  facet_of = names(2), edge_of = names(1);
  const auto copies = edge_copies(tree, e);
  ASSERT_TRUE(t_.operations->split(NodeId::root, e));
  const auto facets_after = names(2), edges_after = names(1);
  for (std::size_t i = 0; i < copies.size(); ++i) {
    const auto [node, a, b] = copies[i];
    const Mesh& mesh = tree.mesh(tree.nodes()[node]);
    const int c = static_cast<int>(mesh.vertex(mesh.switch_dart(t_.operations->copies()[i].dart, 0)));
    const Index whole = edge_of[node].at(oracle::simplex({a, b}));
    for (const int end : {a, b})
      EXPECT_EQ(std::get<1>(values_[node].all())[edges_after[node].at(oracle::simplex({end, c}))],
                std::get<1>(before[node])[whole]);
    if (mesh.dimension() != 2) continue;
    for (const auto& [s, f] : facet_of[node])
      if (oracle::contains(s, a) && oracle::contains(s, b))
        for (const int end : {a, b}) {
          const int apex = oracle::minus(s, oracle::simplex({a, b})).v[0];
          const Index half = facets_after[node].at(oracle::simplex({end, c, apex}));
          EXPECT_EQ(values_[node].face(half), std::get<3>(before[node])[f]);
        }
  }
  // Nothing that was there has another value.
  const auto starts_with = [](const auto& now, const auto& old) {
    return now.size() >= old.size() && std::equal(old.begin(), old.end(), now.begin());
  };
  for (std::size_t n = 0; n < before.size(); ++n) {
    const auto now = values_[n].all();
    EXPECT_TRUE(starts_with(std::get<0>(now), std::get<0>(before[n])));
    EXPECT_TRUE(starts_with(std::get<1>(now), std::get<1>(before[n])));
    EXPECT_TRUE(starts_with(std::get<2>(now), std::get<2>(before[n])));
    EXPECT_TRUE(starts_with(std::get<3>(now), std::get<3>(before[n])));
  }
}

TEST(UserValues_, OfVerticesAndFacesAreLeftAloneByCollapseAndSwap) {
  Tree t(grid(3, 3));
  const UserValues values(t.tree->mesh(NodeId::root));
  const auto all = values.all();
  const auto others_are_unchanged = [&] {
    EXPECT_EQ(std::get<0>(values.all()), std::get<0>(all));
    EXPECT_EQ(std::get<3>(values.all()), std::get<3>(all));
  };
  ASSERT_TRUE(t.operations->collapse(NodeId::root, edge(t, NodeId::root, 5, 10), Placement::keep_a()));
  others_are_unchanged();
  EXPECT_EQ(std::get<1>(values.all()), std::get<1>(all)) << "edges at the survivor keep theirs";
  const Dart e = edge(t, NodeId::root, 0, 5);
  const Index swapped = t.tree->mesh(NodeId::root).simplex(e, 1);
  ASSERT_TRUE(t.operations->swap(NodeId::root, e));
  others_are_unchanged();
  auto edges = std::get<1>(all);
  edges[swapped] = {};
  EXPECT_EQ(std::get<1>(values.all()), edges) << "the new edge has nothing";
}

}  // namespace
}  // namespace multimesh::test
