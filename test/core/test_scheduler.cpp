// SPDX-License-Identifier: BSD-3-Clause
// The priority scheduler misses nothing: after each operation, everything that it changed is in the queue.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>

#include "multimesh/scheduler.hpp"
#include "test/core/drawn.hpp"

namespace multimesh::test {
namespace {

class Scheduled {
 public:
  explicit Scheduled(Tree& tree) : tree_(tree), root_(tree.tree->mesh(NodeId::root)) {}
  Point3 point(Dart d) const { return tree_.points(NodeId::root)[root_.vertex(d)]; }
  Dart other(Dart e) const { return root_.reorder(e, exchange_ends); }
  double length(Dart e) const { return (point(e) - point(other(e))).norm(); }
  double longest() const {
    double most = 0;
    for (const Dart d : all_darts(root_)) most = std::max(most, length(d));
    return most;
  }
  bool finished(double) const { return false; }

 protected:
  Tree& tree_;
  const Mesh& root_;
};

/// Splits all edges that are longer, longest first.
struct Splitting : Scheduled {
  Splitting(Tree& tree, double most) : Scheduled(tree), most(most) {}
  std::optional<double> cost(Dart e) const {
    return length(e) > most ? std::optional(-length(e)) : std::nullopt;
  }
  Outcome apply(Dart e, double) { return tree_.operations->split(NodeId::root, e); }
  double most;
};

Shape triangle(std::mt19937& random) {
  const auto r = [&] { return 4 * std::uniform_real_distribution<>()(random); };
  return {triangles({{0, 1, 2}}), {{r(), r(), 0}, {r(), r(), 0}, {r(), r(), 0}}};
}

TEST(PriorityScheduler, SplitsUntilNothingIsTooLong) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::mt19937 random(seed);
    Tree tree(triangle(random));
    Splitting policy(tree, 0.3 + 0.4 * std::uniform_real_distribution<>()(random));
    (void)PriorityScheduler(*tree.operations).run(policy);
    ASSERT_LE(policy.longest(), policy.most) << "seed " << seed;
  }
}

// With children, and in dimension 3, where edges have other indices after an operation around them.
TEST(PriorityScheduler, SplitsTreesOfAllKindsUntilNothingIsTooLong) {
  for (const TreeKind& kind : tree_kinds()) {
    const auto tree = kind.make(24, 3);
    Splitting policy(*tree, 0.7 * Scheduled(*tree).longest());
    (void)PriorityScheduler(*tree->operations).run(policy);
    EXPECT_LE(policy.longest(), policy.most) << kind.name;
  }
}

/// The same on any mesh of a tree.
struct SplittingBelow {
  double length(Dart e) const {
    const Mesh& mesh = tree.tree->mesh(node);
    const auto& p = tree.points(node);
    return (p[mesh.vertex(e)] - p[mesh.vertex(mesh.reorder(e, exchange_ends))]).norm();
  }
  double longest() const {
    double most_now = 0;
    for (const Dart d : all_darts(tree.tree->mesh(node))) most_now = std::max(most_now, length(d));
    return most_now;
  }
  std::optional<double> cost(Dart e) const {
    return length(e) > most ? std::optional(-length(e)) : std::nullopt;
  }
  Outcome apply(Dart e, double) { return tree.operations->split(node, e); }
  bool finished(double) const { return false; }

  Tree& tree;
  NodeId node;
  double most;
};

TEST(PriorityScheduler, SplitsAnyMeshOfATreeUntilNothingIsTooLong) {
  for (const TreeKind& kind : tree_kinds()) {
    const auto tree = kind.make(24, 5);
    for (const NodeId n : tree->tree->nodes()) {
      if (n == NodeId::root || tree->tree->mesh(n).dimension() == 0) continue;
      SplittingBelow policy{*tree, n, 1};
      policy.most = 0.7 * policy.longest();
      (void)PriorityScheduler(*tree->operations, n).run(policy);
      EXPECT_LE(policy.longest(), policy.most) << kind.name << ", mesh " << index(n);
    }
  }
}

/// A vertex is inserted at the middle of a triangle while one of its sides is too long.
struct Inserting : Splitting {
  using Splitting::Splitting;
  Outcome apply(Dart e, double) {
    return inserted++ < 40 ? tree_.operations->split_simplex(NodeId::root, e, 2)
                           : tree_.operations->split(NodeId::root, e);
  }
  int inserted = 0;
};

TEST(PriorityScheduler, InsertsUntilNothingIsTooLong) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    std::mt19937 random(seed);
    Tree tree(triangle(random));
    Inserting policy(tree, 0.5);
    (void)PriorityScheduler(*tree.operations).run(policy);
    ASSERT_LE(policy.longest(), policy.most) << "seed " << seed;
  }
}

/// Swaps edges of a flat mesh until the angles opposite of none add up to more than pi (Delaunay).
struct Swapping : Scheduled {
  using Scheduled::Scheduled;
  static double angle(const Point3& at, const Point3& x, const Point3& y) {
    return std::acos(std::clamp(dot(x - at, y - at) / ((x - at).norm() * (y - at).norm()), -1.0, 1.0));
  }
  std::optional<double> cost(Dart e) const {
    const Dart beyond = root_.switch_dart(e, 2);
    if (beyond == no_dart) return std::nullopt;
    const Point3 a = point(e), b = point(other(e));
    const auto apex = [&](Dart d) { return point(root_.reorder(d, permutation(2, 0, 1))); };
    const double sum = angle(apex(e), a, b) + angle(apex(beyond), a, b);
    return sum > 3.1415926535 + 1e-6 ? std::optional(-sum) : std::nullopt;
  }
  Outcome apply(Dart e, double) { return tree_.operations->swap(NodeId::root, e); }
};

TEST(PriorityScheduler, SwapsUntilEveryEdgeIsDelaunay) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    std::mt19937 random(seed);
    Shape shape = grid(12, 12);
    const auto shift = [&] { return std::uniform_real_distribution<>(-0.2, 0.2)(random); };
    for (Index v = 0; v < shape.points.size(); ++v) {  // sheared: a valid triangulation of bad triangles
      const double x = v / 13 + shift(), y = v % 13 + shift();
      shape.points[v] = {x + 2 * y, y, 0};
    }
    Tree tree(shape);
    Swapping policy(tree);
    PriorityScheduler scheduler(*tree.operations);
    (void)scheduler.run(policy);
    const Mesh& root = tree.tree->mesh(NodeId::root);
    for (const Dart d : all_darts(root)) {
      if (!policy.cost(d)) continue;
      EXPECT_TRUE(tree.operations->why_not_swap(NodeId::root, d).refused())
          << "seed " << seed << ": an edge is left that could be swapped";
    }
  }
}

/// Lets vertices sink to their lowest neighbour.
struct Sinking : Scheduled {
  using Scheduled::Scheduled;
  std::optional<double> cost(Dart e) const {
    const double step = std::abs(point(e)[2] - point(other(e))[2]);
    return step > 0.01 ? std::optional(-step) : std::nullopt;
  }
  Outcome apply(Dart e, double) {
    const Dart high = point(e)[2] > point(other(e))[2] ? e : other(e);
    return tree_.move(NodeId::root, high, Point3(0, 0, point(other(high))[2] - point(high)[2]));
  }
};

/// Collapses short edges, and counts how often each is asked between changes at its ends.
struct Collapsing : Scheduled {
  Collapsing(Tree& tree, double least) : Scheduled(tree), least(least) {}
  std::optional<double> cost(Dart e) const {
    return length(e) < least ? std::optional(length(e)) : std::nullopt;
  }
  Outcome apply(Dart e, double) {
    const Index a = root_.vertex(e), b = root_.vertex(other(e));
    ++asked[{std::min(a, b), std::max(a, b), changes[a], changes[b]}];
    const Outcome o = tree_.operations->collapse(NodeId::root, e, Placement::at(0.5));
    if (!o) return o;
    DartBuffer star;
    root_.star(o.root, 0, star);
    std::set<Index> around;
    for (const Dart d : star) {
      Index v[4];
      root_.vertices(d, v);
      around.insert(v, v + 3);
    }
    for (const Index v : around) ++changes[v];
    return o;
  }
  double least;
  std::map<std::array<Index, 4>, int> asked;
  std::map<Index, Index> changes;  // of the star of a vertex
};

// The curves below refuse many.
TEST(PriorityScheduler, AsksNothingTwiceInVainAndNothingIsLeft) {
  for (const TreeKind& kind : tree_kinds()) {
    const auto tree = kind.make(24, 3);
    const Mesh& root = tree->tree->mesh(NodeId::root);
    if (root.dimension() != 2) continue;
    Collapsing policy(*tree, 0.8 * Scheduled(*tree).longest());
    PriorityScheduler scheduler(*tree->operations);
    EXPECT_EQ(scheduler.run(policy), PriorityScheduler::Stop::exhausted);
    for (const auto& [question, times] : policy.asked) EXPECT_EQ(times, 1) << kind.name;
    const std::size_t asked = policy.asked.size();
    EXPECT_EQ(scheduler.resume(policy), PriorityScheduler::Stop::exhausted);
    EXPECT_EQ(policy.asked.size(), asked) << kind.name << ": nothing has changed since";
    for (Index e = 0; e < root.capacity(1); ++e)
      if (root.is_live(1, e) && policy.cost(root.dart_of(1, e))) {
        EXPECT_FALSE(tree->operations->collapse(NodeId::root, root.dart_of(1, e), Placement::at(0.5)))
            << kind.name << ": an edge is left that could be collapsed";
      }
  }
}

TEST(PriorityScheduler, MovesUntilNothingIsLeft) {
  std::mt19937 random(1);
  Shape shape = grid(8, 8);
  for (auto& p : shape.points) p[2] = std::uniform_real_distribution<>()(random);
  Tree tree(shape);
  Sinking policy(tree);
  EXPECT_EQ(PriorityScheduler(*tree.operations).run(policy), PriorityScheduler::Stop::exhausted);
  for (const Dart d : all_darts(tree.tree->mesh(NodeId::root))) EXPECT_FALSE(policy.cost(d));
}

}  // namespace
}  // namespace multimesh::test
