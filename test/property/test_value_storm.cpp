// SPDX-License-Identifier: BSD-3-Clause
// Random values on vertices, edges, faces and corners of every mesh of random trees. After each random
// operation they are compared with those that the documented rules give on plain vertex sets.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include "test/property/value_columns.hpp"
#include "test/support/fingerprint.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {
namespace {

/// One operation on one mesh: what the library reported about its vertices.
struct Told {
  Operation operation;
  std::size_t node;
  unsigned a, b, c;       ///< split: the new vertex c; collapse: b survives
  unsigned l = 0, r = 0;  ///< flip
  double t = 0;
};

/// Notes what operations do to vertices.
class Listener final : public Attribute {
 public:
  Listener(NodeId n, std::vector<std::vector<Told>>& out, std::vector<Told>& pending)
      : Attribute(n), out_(out), pending_(pending) {}
  void update(Operation operation, const VertexChange& c) override {
    if (operation != Operation::relocate)
      pending_.push_back({operation, index(c.node), c.a, c.b, c.vertex, 0, 0, c.t});
  }
  void finish(const Event& event) override {
    if (node() != NodeId::root) return;
    if (event.operation == Operation::flip)
      for (const Copy& copy : event.copies.all()) {
        const Mesh& mesh = event.tree.mesh(copy.node);
        Index at_a[4], at_b[4];
        mesh.vertices(copy.dart, at_a);
        mesh.vertices(mesh.switch_dart(copy.dart, 2), at_b);
        pending_.push_back({event.operation, index(copy.node), at_a[2], at_b[2], 0, at_a[0], at_a[1]});
      }
    if (!pending_.empty()) out_.push_back(std::move(pending_));
    pending_.clear();
  }
  Mark mark() const override { return 0; }
  void rollback(Mark) override {}
  void forget() override {}

 private:
  std::vector<std::vector<Told>>& out_;
  std::vector<Told>& pending_;
};

class ValueStorm {
 public:
  ValueStorm(Tree& tree, unsigned seed) : tree_(tree), random_(seed) {
    for (std::uint32_t i = 0; i < tree.tree->nodes().size(); ++i) {
      const NodeId n{i};
      columns_.push_back(std::make_unique<ValueColumns>(*tree.operations, *tree.tree, n, random_));
      listeners_.push_back(std::make_unique<Listener>(n, told_, pending_));
      tree.operations->add(*listeners_.back());
    }
    model_ = read();
  }

  /// An operation that may be refused, or a few that are taken back or kept together.
  void step() {
    if (random_() % 16 == 0) return scope();
    operate();
    if (++steps_ % 60 == 0) compact();
  }

  /// The first value that is not what the rules give, or an empty string.
  std::string fault() const {
    const auto now = read();
    for (std::size_t n = 0; n < now.size(); ++n)
      if (const std::string f = first_difference(model_[n], now[n]); !f.empty())
        return "mesh " + std::to_string(n) + ", " + f;
    return {};
  }

  std::size_t done = 0, refused = 0, undone = 0, won = 0;

 private:
  using Model = std::vector<ValueMesh>;

  Model read() const {
    Model all;
    for (const auto& c : columns_) all.push_back(c->read());
    return all;
  }

  void scope() {
    const Model before = model_;
    const auto words = fingerprint(tree_);
    struct Scope {
      Transaction transaction;
    };
    std::unique_ptr<Scope> scope(new Scope{tree_.operations->transaction()});
    for (auto i = 1 + random_() % 6; i-- > 0;) operate();
    if (random_() % 3 == 0) return scope->transaction.commit();
    scope.reset();
    ++undone;
    model_ = before;
    EXPECT_EQ(fingerprint(tree_), words);
  }

  Dart random_dart(NodeId n) {
    const Mesh& mesh = tree_.tree->mesh(n);
    const int d = mesh.dimension();
    for (;;) {
      const auto f = static_cast<Index>(random_() % mesh.capacity(d));
      if (mesh.is_live(d, f))
        return mesh.reorder(mesh.dart_of(d, f), {static_cast<std::uint8_t>(random_() % number_of_orders(d))});
    }
  }

  void operate() {
    told_.clear();
    pending_.clear();
    const auto nodes = tree_.tree->nodes();
    NodeId n = nodes[random_() % nodes.size()];
    while (tree_.tree->mesh(n).dimension() == 0) n = tree_.tree->parent(n);  // points have no edges
    const Dart d = random_dart(n);
    Propagation& ops = *tree_.operations;
    const auto k = static_cast<unsigned>(tree_.tree->mesh(n).dimension());
    auto choice = random_() % 100;
    if (model_[0].facets.size() > 60) choice = 30 + choice / 2;
    const auto covered = covered_by_meshes_below();
    bool single = true, ok = false;
    if (choice < 28) {
      ok = bool(ops.split(n, d, 0.25 * static_cast<double>(1 + random_() % 3)));
    } else if (choice < 75) {
      ok = bool(ops.collapse(n, d, Placement::at(0.125 * static_cast<double>(random_() % 9))));
    } else {
      single = false;
      ok = bool(choice < 79   ? ops.split_simplex(n, d, 1 + static_cast<int>(random_() % k))
                : choice < 82 ? ops.swap_face(n, d)
                : choice < 95 ? ops.swap(n, d)
                              : ops.swap_by_split_and_collapse(n, d));
    }
    ok ? ++done : ++refused;
    if (ok)
      for (const auto& told : told_) apply(told, covered, !single);
  }

  /// Per mesh, the simplices that are images of facets of a mesh below, of their own dimension.
  std::vector<std::set<Vertices>> covered_by_meshes_below() const {
    const MultiMesh& tree = *tree_.tree;
    std::vector<std::set<Vertices>> covered(model_.size());
    for (const NodeId n : tree.nodes()) {
      const Mesh& mesh = tree.mesh(n);
      const int d = mesh.dimension();
      for (Index f = 0; n != NodeId::root && f < mesh.capacity(d); ++f) {
        if (!mesh.is_live(d, f)) continue;
        Dart image = mesh.dart_of(d, f);
        for (NodeId at = n; at != NodeId::root;) {
          image = tree.to_parent(at, image);
          at = tree.parent(at);
          Index v[4];
          tree.mesh(at).vertices(image, v);
          covered[index(at)].insert({v, v + d + 1});
        }
      }
    }
    return covered;
  }

  void apply(const std::vector<Told>& told, const std::vector<std::set<Vertices>>& covered,
             bool taking_back) {
    for (auto c = told.begin(); c != told.end(); ++c) {
      ValueMesh& mesh = model_[c->node];
      if (c->operation == Operation::split) mesh.split(c->a, c->b, c->c, c->t);
      if (c->operation == Operation::flip) mesh.flip(c->a, c->b, c->l, c->r);
    }
    // Copies in one mesh are collapsed last first.
    std::vector<std::map<unsigned, unsigned>> names(model_.size());
    for (auto c = told.rbegin(); c != told.rend(); ++c) {
      if (c->operation != Operation::collapse) continue;
      const auto wins = winners(covered[c->node], c->a, c->b, names[c->node]);
      won += wins.size();
      model_[c->node].collapse(c->a, c->b, c->t, wins, taking_back);
      names[c->node][c->a] = c->b;
    }
  }

  static std::set<Vertices> winners(const std::set<Vertices>& covered, unsigned a, unsigned b,
                                    const std::map<unsigned, unsigned>& names) {
    std::set<Vertices> wins;
    for (const Vertices& s : covered) {
      if (!s.contains(a) || s.contains(b)) continue;
      Vertices other = s, now = s;
      other.erase(a), other.insert(b);
      if (covered.contains(other)) continue;
      for (const auto& [old, name] : names)
        if (now.erase(old) > 0) now.insert(name);
      wins.insert(now);
    }
    return wins;
  }

  void compact() {
    const auto moved = tree_.tree->compact();
    for (std::size_t i = 0; i < columns_.size(); ++i) columns_[i]->follow(moved[i]);
    const Model before = std::move(model_);
    model_ = read();
    for (std::size_t i = 0; i < before.size(); ++i) {
      const ValueMesh renamed = with_names(before[i], moved[i].simplices[0]);
      EXPECT_EQ(first_difference(renamed, model_[i]), "") << "compacted, mesh " << i;
    }
  }

  static Vertices named(const Vertices& s, const std::vector<Index>& names) {
    Vertices now;
    for (const unsigned v : s) now.insert(names.at(v));
    return now;
  }
  static ValueMesh with_names(const ValueMesh& mesh, const std::vector<Index>& names) {
    ValueMesh now;
    now.dimension = mesh.dimension;
    for (const auto& [v, values] : mesh.vertices) now.vertices[names.at(v)] = values;
    for (const auto& [s, values] : mesh.edges) now.edges[named(s, names)] = values;
    for (const auto& [s, values] : mesh.faces) now.faces[named(s, names)] = values;
    for (const auto& [s, f] : mesh.facets) {
      Facet& g = now.facets[named(s, names)];
      g.values = f.values;
      for (const auto& [v, values] : f.corners) g.corners[names.at(v)] = values;
    }
    return now;
  }

  static std::string text(const Vertices& s) {
    std::string all;
    for (const unsigned v : s) all += std::to_string(v) + ' ';
    return all;
  }
  template <class Map>
  static std::string first_difference(const char* what, const Map& expected, const Map& actual) {
    for (const auto& [s, v] : expected) {
      if (!actual.contains(s)) return std::string(what) + " " + text(s) + "has no value";
      if (const char* field = difference(v, actual.at(s)))
        return std::string(what) + " " + text(s) + "differs in " + field;
    }
    return expected.size() == actual.size() ? "" : std::string(what) + ": too many have a value";
  }
  static std::string first_difference(const ValueMesh& expected, const ValueMesh& actual) {
    std::map<Vertices, Values> vertices[2], facets[2], at_corners[2];
    int i = 0;
    for (const ValueMesh* m : {&expected, &actual}) {
      for (const auto& [v, values] : m->vertices) vertices[i][{v}] = values;
      for (const auto& [s, f] : m->facets) facets[i][s] = f.values;
      ++i;
    }
    std::string f = first_difference("vertex", vertices[0], vertices[1]);
    if (f.empty()) f = first_difference("edge", expected.edges, actual.edges);
    if (f.empty()) f = first_difference("face", expected.faces, actual.faces);
    if (f.empty()) f = first_difference("facet", facets[0], facets[1]);
    for (const auto& [s, facet] : expected.facets)
      for (const auto& [v, values] : facet.corners)
        if (f.empty())
          if (const char* field = difference(values, actual.facets.at(s).corners.at(v)))
            f = "corner " + std::to_string(v) + " of facet " + text(s) + "differs in " + field;
    return f;
  }

  Tree& tree_;
  std::mt19937 random_;
  std::vector<std::unique_ptr<ValueColumns>> columns_;
  std::vector<std::unique_ptr<Listener>> listeners_;
  std::vector<std::vector<Told>> told_;
  std::vector<Told> pending_;
  Model model_;
  std::size_t steps_ = 0;
};

/// How many operations in total: MULTIMESH_VALUE_OPERATIONS, for long runs by hand.
std::size_t operations() {
  const char* given = std::getenv("MULTIMESH_VALUE_OPERATIONS");
  return given ? std::strtoull(given, nullptr, 10) : 8'000;
}

class ValueRules : public testing::TestWithParam<TreeKind> {};

TEST_P(ValueRules, HoldInEveryMesh) {
  const std::size_t total = operations() / tree_kinds().size();
  std::size_t tried = 0, done = 0, undone = 0;
  for (unsigned seed = 0; tried < total; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const auto tree = GetParam().make(24, seed);
    ValueStorm storm(*tree, seed);
    ASSERT_EQ(storm.fault(), "");
    for (std::size_t i = 0; i < 250; ++i, ++tried) {
      storm.step();
      ASSERT_EQ(storm.fault(), "") << "after step " << i;
      ASSERT_FALSE(HasFailure());
    }
    done += storm.done;
    undone += storm.undone;
  }
  EXPECT_GT(done, tried / 10) << "nearly everything was refused: the test says little";
  EXPECT_GT(undone, tried / 100);
}

INSTANTIATE_TEST_SUITE_P(Trees, ValueRules, testing::ValuesIn(tree_kinds()),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace multimesh::test
