// SPDX-License-Identifier: BSD-3-Clause
// An operation that is refused or interrupted leaves every word as it was.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/core/user_values.hpp"
#include "test/support/fingerprint.hpp"

namespace multimesh::test {
namespace {

using Operate = std::function<Outcome(Propagation&, NodeId, Dart)>;

struct NamedOperation {
  std::string name;
  Operate run;
  friend void PrintTo(const NamedOperation& o, std::ostream* out) { *out << o.name; }
};

const std::vector<NamedOperation>& operations() {
  static const std::vector<NamedOperation> all{
      {"Split", [](Propagation& o, NodeId n, Dart e) { return o.split(n, e, 0.25); }},
      {"Collapse", [](Propagation& o, NodeId n, Dart e) { return o.collapse(n, e); }},
      {"CollapseKeepA",
       [](Propagation& o, NodeId n, Dart e) { return o.collapse(n, e, Placement::keep_a()); }},
      {"Swap", [](Propagation& o, NodeId n, Dart e) { return o.swap(n, e); }},
      {"SwapBySplit", [](Propagation& o, NodeId n, Dart e) { return o.swap_by_split_and_collapse(n, e); }},
      {"SwapFace", [](Propagation& o, NodeId n, Dart f) { return o.swap_face(n, f); }},
      {"SplitFacet",
       [](Propagation& o, NodeId n, Dart d) { return o.split_simplex(n, d, o.tree().mesh(n).dimension()); }},
      {"Relocate", [](Propagation& o, NodeId n, Dart v) { return o.relocate(n, v, [](const Event&) {}); }}};
  return all;
}

/// A few trees with everything in them, and the user's own properties on each mesh.
struct Loaded {
  explicit Loaded(unsigned seed)
      : t(seed < tree_kinds().size() ? tree_kinds()[seed].make(16, seed)
          : seed % 2                 ? random_small_tree(seed, 10)
                                     : random_small_solid_tree(seed, 10)) {
    for (const NodeId n : t->tree->nodes()) values.emplace_back(t->tree->mesh(n));
  }
  struct State {
    std::vector<std::uint64_t> words;
    std::vector<UserValues::All> values;
    friend bool operator==(const State&, const State&) = default;
  };
  State state() {
    State s{fingerprint(*t), {}};
    for (const UserValues& v : values) s.values.push_back(v.all());
    return s;
  }
  std::span<Attribute* const> attributes() {
    list.clear();
    for (const NodeId n : t->tree->nodes()) list.push_back(&t->attribute(n));
    return list;
  }
  template <class Test>
  void on_some_edges(std::size_t stride, const Test& test) {
    for (const NodeId n : t->tree->nodes()) {
      if (t->tree->mesh(n).dimension() == 0) continue;  // no edges
      const DartBuffer darts = all_darts(t->tree->mesh(n));
      // At most some hundred; 24 orderings of a tetrahedron are many.
      const std::size_t step = darts.size() < 200 ? stride : stride * (2 * (darts.size() / 200) + 1);
      for (std::size_t i = 0; i < darts.size(); i += step)
        if (t->tree->mesh(n).is_dart(darts[i])) test(n, darts[i]);
    }
  }
  std::unique_ptr<Tree> t;
  std::vector<UserValues> values;
  std::vector<Attribute*> list;
};

const auto number_of_trees = static_cast<unsigned>(tree_kinds().size() + 6);

class Refusals : public testing::TestWithParam<NamedOperation> {};

TEST_P(Refusals, ChangeNothing) {
  for (unsigned seed = 0; seed < number_of_trees; ++seed) {
    Loaded x(seed);
    auto before = x.state();
    x.on_some_edges(5, [&](NodeId n, Dart e) {
      const Outcome o = GetParam().run(*x.t->operations, n, e);
      if (o) {
        before = x.state();
        return;
      }
      EXPECT_NE(o.refusal.check, Check::none);
      ASSERT_EQ(x.state(), before);
    });
  }
}

TEST_P(Refusals, OfInvariantsChangeNothing) {
  for (const bool after : {false, true}) {
    int asked = 0;
    for (unsigned seed = 0; seed < number_of_trees; ++seed) {
      Loaded x(seed);
      const auto no = [&](const Event& e) {
        ++asked;
        if (after) {
          EXPECT_EQ(validate(e.tree), std::vector<std::string>{});
        }
        return false;
      };
      FunctionInvariant::Test before_test, after_test;
      (after ? after_test : before_test) = no;
      FunctionInvariant stubborn("stubborn", before_test, after_test);
      x.t->operations->add(stubborn);
      const auto before = x.state();
      x.on_some_edges(7, [&](NodeId n, Dart e) {
        const int asked_before = asked;
        const Outcome o = GetParam().run(*x.t->operations, n, e);
        ASSERT_FALSE(o);
        EXPECT_EQ(o.refusal.check == Check::invariant, asked > asked_before);
        ASSERT_EQ(x.state(), before);
      });
    }
    EXPECT_GT(asked, 0);
  }
}

struct Interruption {};

TEST_P(Refusals, ByAnExceptionAtAnyStageChangeNothing) {
  int most_stages = 0;
  for (unsigned seed = 0; seed < number_of_trees; ++seed) {
    Loaded x(seed);
    Propagation& ops = *x.t->operations;
    const auto before = x.state();
    x.on_some_edges(11, [&](NodeId n, Dart e) {
      const auto stages = [&] {
        const Transaction undone(*x.t->tree, x.attributes());
        int count = 0;
        ops.on_stage = [&](int) { ++count; };
        (void)GetParam().run(ops, n, e);
        return count;
      };
      const int all = stages();
      ASSERT_EQ(x.state(), before) << "a transaction that is not committed";
      most_stages = std::max(most_stages, all);
      for (const bool nested : {false, true})
        for (int stop = 0; stop < all; ++stop) {
          std::optional<Transaction> outer;
          if (nested) outer.emplace(*x.t->tree, x.attributes());
          ops.on_stage = [&, count = 0](int) mutable {
            if (count++ == stop) throw Interruption();
          };
          EXPECT_THROW((void)GetParam().run(ops, n, e), Interruption);
          ASSERT_EQ(x.state(), before) << "stage " << stop;
        }
      ops.on_stage = {};
    });
  }
  EXPECT_GE(most_stages, 3);
}

TEST_P(Refusals, ByAnExceptionOfAnAttributeOrInvariantChangeNothing) {
  for (unsigned seed = 0; seed < number_of_trees; ++seed)
    for (const bool attribute : {true, false}) {
      Loaded x(seed);
      const NodeId last = x.t->tree->nodes().back();
      std::vector<int> values(1000, 0);
      VertexAttribute<int> bad(last, values,
                               [](Operation, const VertexChange&) -> int { throw Interruption(); });
      FunctionInvariant worse("worse", {}, [](const Event&) -> bool { throw Interruption(); });
      attribute ? void(x.t->operations->add(bad)) : void(x.t->operations->add(worse));
      auto before = x.state();
      x.on_some_edges(7, [&](NodeId n, Dart e) {
        try {
          if (GetParam().run(*x.t->operations, n, e)) before = x.state();  // the edge has no copy in `last`
        } catch (const Interruption&) {
        }
        ASSERT_EQ(x.state(), before);
      });
    }
}

INSTANTIATE_TEST_SUITE_P(All, Refusals, testing::ValuesIn(operations()),
                         [](const auto& operation) { return operation.param.name; });

/// One refusal for each reason.
TEST(Refusal, OfEveryReasonChangesNothing) {
  struct Case {
    Check check;
    std::function<std::pair<Tree, Outcome>(std::vector<std::uint64_t>&)> run;
  };
  const auto collapse = [](Tree t, Index a, Index b, Placement p, std::vector<std::uint64_t>& before) {
    before = fingerprint(t);
    const Outcome o = t.operations->collapse(NodeId::root, edge(t, NodeId::root, a, b), p);
    return std::pair{std::move(t), o};
  };
  using Words = std::vector<std::uint64_t>;
  const std::vector<Case> cases{
      {Check::link_condition,
       [&](Words& w) {
         return collapse(drawn({{0, 1, 2}}), 0, 1, {}, w);
       }},
      {Check::gluing,
       [&](Words& w) {
         Tree t = two_neighbors();
         (void)add_drawn(t, NodeId::root, segments({{0, 1}, {2, 0}}), {0, 1, 2});
         return collapse(std::move(t), 1, 2, {}, w);
       }},
      {Check::placement,
       [&](Words& w) {
         Tree t = two_neighbors();
         (void)add_cut_on_edge01(t, NodeId::root);
         return collapse(std::move(t), 1, 2, Placement::keep_b(), w);
       }},
      {Check::gluing,
       [&](Words& w) {
         Tree t(grid(3, 3));
         (void)t.add_tagged(NodeId::root, 0, [](Index v) { return v == 5 || v == 6; });
         return collapse(std::move(t), 5, 6, {}, w);
       }},
      {Check::placement,
       [&](Words& w) {
         Tree t(grid(3, 3));
         (void)t.add_tagged(NodeId::root, 0, [](Index v) { return v == 5; });
         return collapse(std::move(t), 5, 6, Placement::keep_b(), w);
       }},
      {Check::contact,
       [&](Words& w) {
         Tree t(grid(3, 3));
         (void)add_drawn(t, NodeId::root, segments({{0, 1}}), {5, 6});
         t.operations->set({.contact = true});
         return collapse(std::move(t), 4, 5, {}, w);
       }},
      {Check::locked,
       [&](Words& w) {
         Tree t(grid(3, 3));
         for (const Index v : {5U, 6U}) t.tree->mesh(NodeId::root).set_locked(v, true);
         return collapse(std::move(t), 5, 6, {}, w);
       }},
  };
  for (const Case& c : cases) {
    std::vector<std::uint64_t> before;
    auto [tree, outcome] = c.run(before);
    EXPECT_EQ(outcome.refusal.check, c.check)
        << to_string(c.check) << " expected, got " << to_string(outcome.refusal.check);
    EXPECT_EQ(fingerprint(tree), before) << to_string(c.check);
    EXPECT_EQ(tree.operations->statistics().refused_by(c.check), 1U);
  }
}

}  // namespace
}  // namespace multimesh::test
