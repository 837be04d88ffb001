// SPDX-License-Identifier: BSD-3-Clause
// Calls in the middle of an operation, and additions inside a transaction: refused, and the tree is
// unchanged.
#include <gtest/gtest.h>

#include "multimesh/column.hpp"
#include "test/core/drawn.hpp"
#include "test/support/fingerprint.hpp"

namespace multimesh::test {
namespace {

struct Call {
  const char* name;
  std::function<void(Tree&)> run;
};

Dart inner_edge(const Tree& t) {
  return edge(t, NodeId::root, 0, 1);
}
/// A dart of the mesh in its state in the middle of an operation.
Dart any(const Tree& t) {
  const Mesh& root = t.tree->mesh(NodeId::root);
  Index f = 0;
  while (!root.is_live(2, f)) ++f;
  return root.dart_of(2, f);
}
const auto everywhere = [](const Event&) { return true; };

const std::vector<Call>& calls() {
  static FunctionInvariant invariant("late", everywhere);
  static const std::vector<Call> all = {
      {"split", [](Tree& t) { (void)t.operations->split(NodeId::root, any(t)); }},
      {"split by another", [](Tree& t) { (void)Propagation(*t.tree).split(NodeId::root, any(t)); }},
      {"collapse", [](Tree& t) { (void)t.operations->collapse(NodeId::root, any(t)); }},
      {"collapse by choice",
       [](Tree& t) {
         (void)t.operations->collapse(NodeId::root, any(t),
                                      [](const Event&, std::optional<double>) { return 0.5; });
       }},
      {"swap", [](Tree& t) { (void)t.operations->swap(NodeId::root, any(t)); }},
      {"swap in steps",
       [](Tree& t) { (void)t.operations->swap_by_split_and_collapse(NodeId::root, any(t)); }},
      {"swap of a face", [](Tree& t) { (void)t.operations->swap_face(NodeId::root, any(t)); }},
      {"split of a simplex", [](Tree& t) { (void)t.operations->split_simplex(NodeId::root, any(t), 2); }},
      {"relocate", [](Tree& t) { (void)t.operations->relocate(NodeId::root, any(t), [](const Event&) {}); }},
      {"judge", [](Tree& t) { (void)t.operations->judge(NodeId::root, any(t)); }},
      {"why not collapse", [](Tree& t) { (void)t.operations->why_not_collapse(NodeId::root, any(t)); }},
      {"why not swap", [](Tree& t) { (void)t.operations->why_not_swap(NodeId::root, any(t)); }},
      {"transaction", [](Tree& t) { const auto scope = t.operations->transaction(); }},
      {"transaction by hand", [](Tree& t) { const Transaction scope(*t.tree, {}); }},
      {"add an attribute", [](Tree& t) { t.operations->add(t.attribute(NodeId::root)); }},
      {"add an invariant", [](Tree& t) { t.operations->add(invariant); }},
      {"options", [](Tree& t) { t.operations->set(LegalityOptions{true}); }},
      {"add a child", [](Tree& t) { (void)t.add_boundary(NodeId::root); }},
      {"detach", [](Tree& t) { (void)t.tree->detach(NodeId{1}); }},
      {"compact", [](Tree& t) { (void)t.tree->compact(); }},
      {"resync", [](Tree& t) { (void)t.tree->resync(); }},
  };
  return all;
}

/// An operation with a hook in it.
struct Hook {
  const char* name;
  std::function<void(Tree&, const std::function<void()>& call)> run;
};

std::unique_ptr<Tree> some_tree() {
  auto t = std::make_unique<Tree>(two_neighbors_plus_one());
  add_cut_on_edge01(*t, NodeId::root);
  return t;
}

void operate(Tree& t, int which) {
  Propagation& o = *t.operations;
  const Dart e = inner_edge(t);
  if (which == 0) (void)o.split(NodeId::root, e);
  if (which == 1) (void)o.collapse(NodeId::root, edge(t, NodeId::root, 0, 4), Placement::at(0.25));
  if (which == 2) (void)o.swap(NodeId::root, edge(t, NodeId::root, 0, 2));
  if (which == 3) (void)o.relocate(NodeId::root, e, [](const Event&) {});
  if (which == 4) (void)o.split_simplex(NodeId::root, e, 2);
}

class Nested : public testing::TestWithParam<int> {};

/// What calls in the end.
class Finisher final : public Attribute {
 public:
  explicit Finisher(const std::function<void()>& call) : Attribute(NodeId::root), call_(call) {}
  void update(Operation, const VertexChange&) override {}
  void finish(const Event&) override { call_(); }
  Mark mark() const override { return 0; }
  void rollback(Mark) override {}
  void forget() override {}

 private:
  const std::function<void()>& call_;
};

const std::vector<Hook>& hooks(int operation) {
  static std::vector<Hook> all;
  all = {
      {"before",
       [=](Tree& t, const auto& call) {
         FunctionInvariant i("hook", [&](const Event&) { return call(), true; });
         t.operations->add(i);
         operate(t, operation);
       }},
      {"after",
       [=](Tree& t, const auto& call) {
         FunctionInvariant i("hook", everywhere, [&](const Event&) { return call(), true; });
         t.operations->add(i);
         operate(t, operation);
       }},
      {"finish",
       [=](Tree& t, const auto& call) {
         Finisher f(call);
         t.operations->add(f);
         operate(t, operation);
       }},
      {"stage",
       [=](Tree& t, const auto& call) {
         t.operations->on_stage = [&](int) { call(); };
         operate(t, operation);
       }},
  };
  if (operation == 0)
    all.push_back({"rule", [](Tree& t, const auto& call) {
                     std::vector<int> values(t.tree->mesh(NodeId::root).capacity(0));
                     VertexAttribute<int> a(NodeId::root, values,
                                            [&](Operation, const VertexChange&) { return call(), 1; });
                     t.operations->add(a);
                     operate(t, 0);
                   }});
  if (operation == 1)
    all.push_back({"chooser", [](Tree& t, const auto& call) {
                     (void)t.operations->collapse(
                         NodeId::root, edge(t, NodeId::root, 0, 4),
                         [&](const Event&, std::optional<double>) { return call(), 0.5; });
                   }});
  if (operation == 3)
    all.push_back({"write", [](Tree& t, const auto& call) {
                     (void)t.operations->relocate(NodeId::root, inner_edge(t), [&](const Event&) { call(); });
                   }});
  return all;
}

TEST_P(Nested, CallsAreRefusedAndLeaveTheTreeAsItWas) {
  const std::size_t number_of_hooks = hooks(GetParam()).size();
  for (std::size_t h = 0; h < number_of_hooks; ++h)
    for (const Call& c : calls()) {
      const auto t = some_tree();
      const auto before = fingerprint(*t);
      const Hook hook = hooks(GetParam())[h];
      SCOPED_TRACE(std::string(c.name) + " inside " + hook.name);
      bool called = false;
      EXPECT_THROW(hook.run(*t,
                            [&] {
                              called = true;
                              c.run(*t);
                            }),
                   UsageError);
      EXPECT_TRUE(called);
      EXPECT_EQ(fingerprint(*t), before);
    }
}

// If a callback catches the error itself, the operation that was requested is still done.
TEST_P(Nested, CallsThatAreCaughtDoNoHarm) {
  const auto t = some_tree(), alone = some_tree();
  FunctionInvariant i("hook", [&](const Event&) {
    for (const Call& c : calls()) EXPECT_THROW(c.run(*t), UsageError) << c.name;
    return true;
  });
  t->operations->add(i);
  operate(*t, GetParam());
  operate(*alone, GetParam());
  EXPECT_EQ(fingerprint(*t), fingerprint(*alone));
}

INSTANTIATE_TEST_SUITE_P(Operations, Nested, testing::Range(0, 5));

TEST(Transaction, CannotEndInTheMiddleOfAnOperation) {
  const auto t = some_tree();
  const auto before = fingerprint(*t);
  auto scope = std::make_unique<Transaction>(*t->tree, std::span<Attribute* const>());
  t->operations->on_stage = [&](int) { scope->commit(); };
  EXPECT_THROW((void)t->operations->split(NodeId::root, inner_edge(*t)), UsageError);
  t->operations->on_stage = {};
  scope.reset();
  EXPECT_EQ(fingerprint(*t), before);
}

TEST(Transaction, TakesNoNewAttributesAndInvariants) {
  const auto t = some_tree();
  std::vector<int> values(t->tree->mesh(NodeId::root).capacity(0));
  VertexAttribute<int> attribute(NodeId::root, values);
  FunctionInvariant invariant("late", everywhere);
  {
    const auto scope = t->operations->transaction();
    EXPECT_THROW(t->operations->add(attribute), UsageError);
    EXPECT_THROW(t->operations->add(invariant), UsageError);
    EXPECT_TRUE(t->operations->split(NodeId::root, inner_edge(*t)));
  }
  EXPECT_NO_THROW(t->operations->add(attribute).add(invariant));
}

}  // namespace
}  // namespace multimesh::test
