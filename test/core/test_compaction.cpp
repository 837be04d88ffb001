// SPDX-License-Identifier: BSD-3-Clause
// Compaction anywhere in a sequence of operations has no observable effect.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "multimesh/openmesh/connectivity.hpp"
#include "multimesh/tet/tet_mesh.hpp"
#include "multimesh/validate.hpp"
#include "test/core/drawn.hpp"
#include "test/core/user_values.hpp"
#include "test/support/storm.hpp"

namespace multimesh::test {
namespace {

/// All live vertices, facets and maps, by names that the user gave to vertices: independent of indices.
struct Observed {
  std::vector<std::vector<std::string>> lines;  ///< per node, sorted
  friend bool operator==(const Observed&, const Observed&) = default;
};

class Compactions : public testing::TestWithParam<unsigned> {
 protected:
  Compactions()
      : t_(GetParam() < 40 ? random_small_tree(GetParam(), 14) : random_small_solid_tree(GetParam(), 14)),
        tree_(*t_->tree),
        random_(GetParam()) {
    for (const NodeId n : tree_.nodes()) {
      values_.emplace_back(tree_.mesh(n));
      mark_some(n);
    }
  }
  bool is_solid(NodeId n) const { return tree_.mesh(n).dimension() == 3; }
  OpenMesh::PolyConnectivity& om(NodeId n) const {
    return dynamic_cast<openmesh::Connectivity&>(tree_.mesh(n)).openmesh();
  }
  unsigned vertex_bits(NodeId n, Index v) const {
    if (is_solid(n)) return tree_.mesh(n).is_locked(v);
    return om(n).status(OpenMesh::VertexHandle(static_cast<int>(v))).bits();
  }
  void mark_some(NodeId n) {
    if (is_solid(n)) {
      for (Index v = 0; v < tree_.mesh(n).capacity(0); ++v)
        dynamic_cast<tet::TetMesh&>(tree_.mesh(n)).set_locked(v, GetParam() % 3 == 0 && v % 5 == 0);
      return;
    }
    for (const auto v : om(n).all_vertices())
      om(n).status(v).set_feature(random_() % 2), om(n).status(v).set_selected(random_() % 2);
    for (const auto e : om(n).all_edges())
      om(n).status(e).set_tagged(random_() % 2), om(n).status(e).set_feature(random_() % 2);
    for (const auto f : om(n).all_faces())
      om(n).status(f).set_locked(random_() % 2), om(n).status(f).set_hidden(random_() % 2);
    if (GetParam() % 3 == 0)
      for (const auto v : om(n).all_vertices()) om(n).status(v).set_locked(v.idx() % 5 == 0);
  }
  void operate(int count) {
    for (int i = 0; i < count; ++i) {
      const NodeId n = tree_.nodes()[random_() % tree_.nodes().size()];
      if (tree_.mesh(n).dimension() == 0) continue;  // no edges
      const DartBuffer darts = all_darts(tree_.mesh(n));
      const Dart d = darts[random_() % darts.size()];
      Propagation& o = *t_->operations;
      (void)(i % 3 == 0 ? o.split(n, d) : i % 3 == 1 ? o.collapse(n, d) : o.swap(n, d));
    }
  }
  std::string describe(std::size_t node, Dart d, int k) const {
    const NodeId n = tree_.nodes()[node];
    const Mesh& mesh = tree_.mesh(n);
    Index v[4];
    mesh.vertices(d, v);
    std::string line;
    for (int i = 0; i <= k; ++i) {
      const Point3& p = t_->points(n)[v[i]];
      line += values_[node].vertex(v[i]) + " " + std::to_string(p[0]) + " " + std::to_string(p[1]) +
              " bits " + std::to_string(vertex_bits(n, v[i])) + "|";
    }
    return line;
  }
  Observed observe() const {
    Observed all;
    for (std::size_t node = 0; node < tree_.nodes().size(); ++node) {
      const NodeId n = tree_.nodes()[node];
      const Mesh& mesh = tree_.mesh(n);
      auto& lines = all.lines.emplace_back();
      for (const Dart d : all_darts(mesh)) {
        std::string line = describe(node, d, mesh.dimension());
        if (mesh.dimension() > 0)
          for (const int i : values_[node].edge(d)) line += " " + std::to_string(i);
        if (is_solid(n)) {
          line += values_[node].face(mesh.facet(d));
        } else if (mesh.dimension() > 0) {
          const auto e = static_cast<int>(mesh.simplex(d, 1));
          line += " edge bits " + std::to_string(om(n).status(OpenMesh::EdgeHandle(e)).bits());
        }
        if (mesh.dimension() == 2) {
          const Index f = mesh.facet(d);
          line += values_[node].face(f) + " face bits " +
                  std::to_string(om(n).status(OpenMesh::FaceHandle(static_cast<int>(f))).bits());
        }
        if (n != NodeId::root) {
          const auto above = std::find(tree_.nodes().begin(), tree_.nodes().end(), tree_.parent(n));
          line += " -> " + describe(static_cast<std::size_t>(above - tree_.nodes().begin()),
                                    tree_.to_parent(n, d), mesh.dimension());
        }
        for (const NodeId below : tree_.children(n))
          line += tree_.facet_over(below, d) == no_index ? "-" : "+";
        lines.push_back(std::move(line));
      }
      std::sort(lines.begin(), lines.end());
    }
    return all;
  }

  /// A bound of the codes of darts.
  static std::uint32_t codes(const Mesh& mesh) {
    const int d = mesh.dimension();
    return d == 3 ? 32 * mesh.capacity(3) : d == 0 ? mesh.capacity(0) : mesh.capacity(1) * (d == 2 ? 4 : 2);
  }

  std::unique_ptr<Tree> t_;
  MultiMesh& tree_;
  std::mt19937 random_;
  std::vector<UserValues> values_;
};

TEST_P(Compactions, ChangeNothingThatCanBeObserved) {
  for (int round = 0; round < 4; ++round) {
    operate(10);
    const Observed before = observe();
    tree_.compact();
    ASSERT_EQ(validate(tree_), std::vector<std::string>{});
    ASSERT_EQ(observe(), before);
    for (const NodeId n : tree_.nodes())
      for (int k = 0; k <= tree_.mesh(n).dimension(); ++k) {
        if (is_solid(n) && (k == 1 || k == 2)) continue;  // implicit: an edge has one index of several
        for (Index i = 0; i < tree_.mesh(n).capacity(k); ++i) ASSERT_TRUE(tree_.mesh(n).is_live(k, i));
      }
  }
}

TEST_P(Compactions, SayWhatMovedWhere) {
  operate(14);
  struct Old {
    NodeId node;
    Dart dart;
    std::string name;
    std::array<Index, 4> simplices;
  };
  std::vector<Old> all;
  const auto name = [&](NodeId n, Dart d) {
    const auto at = std::find(tree_.nodes().begin(), tree_.nodes().end(), n) - tree_.nodes().begin();
    return describe(static_cast<std::size_t>(at), d, tree_.mesh(n).dimension());
  };
  std::vector<std::array<std::vector<bool>, 4>> live;
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    auto& here = live.emplace_back();
    for (int k = 0; k <= mesh.dimension(); ++k)
      for (Index s = 0; s < mesh.capacity(k); ++s)
        here[static_cast<std::size_t>(k)].push_back(mesh.is_live(k, s));
    for (const Dart d : all_darts(mesh)) {
      Old o{n, d, name(n, d), {}};
      for (int k = 0; k <= mesh.dimension(); ++k)
        o.simplices[static_cast<std::size_t>(k)] = mesh.simplex(d, k);
      all.push_back(o);
    }
  }
  const auto moved = tree_.compact();
  for (const Old& o : all) {
    const Compaction& c = moved[index(o.node)];
    const Mesh& mesh = tree_.mesh(o.node);
    const Dart now = c.dart(o.dart);
    ASSERT_TRUE(mesh.is_dart(now));
    EXPECT_EQ(name(o.node, now), o.name);
    for (int k = 0; k <= mesh.dimension(); ++k)
      EXPECT_EQ(c.simplices[static_cast<std::size_t>(k)].at(o.simplices[static_cast<std::size_t>(k)]),
                mesh.simplex(now, k));
  }
  for (std::size_t i = 0; i < live.size(); ++i) {
    const NodeId n = tree_.nodes()[i];
    ASSERT_EQ(moved[index(n)].simplices.size(), static_cast<std::size_t>(tree_.mesh(n).dimension()) + 1);
    for (std::size_t k = 0; k <= static_cast<std::size_t>(tree_.mesh(n).dimension()); ++k)
      for (std::size_t s = 0; s < live[i][k].size(); ++s)
        EXPECT_EQ(moved[index(n)].simplices[k][s] == no_index, !live[i][k][s]);
  }
}

TEST_P(Compactions, OfDeadDartsGiveNoDart) {
  operate(14);
  std::vector<std::vector<bool>> was_dart;
  for (const NodeId n : tree_.nodes()) {
    const Mesh& mesh = tree_.mesh(n);
    auto& here = was_dart.emplace_back();
    for (std::uint32_t c = 0; c < codes(mesh); ++c) here.push_back(mesh.is_dart(Dart{c}));
  }
  const auto moved = tree_.compact();
  for (std::size_t i = 0; i < was_dart.size(); ++i) {
    const NodeId n = tree_.nodes()[i];
    for (std::uint32_t c = 0; c < was_dart[i].size(); ++c) {
      const Dart now = moved[index(n)].dart(Dart{c});
      EXPECT_EQ(now != no_dart && tree_.mesh(n).is_dart(now), was_dart[i][c]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(RandomTrees, Compactions, testing::Range(0U, 67U));

TEST(Compaction_, OfATreeWithoutDeadElementsKeepsAllIndices) {
  Tree t = disk_to_individual(6);
  const auto moved = t.tree->compact();
  for (const Compaction& c : moved)
    for (const auto& simplices : c.simplices)
      for (Index s = 0; s < simplices.size(); ++s) EXPECT_EQ(simplices[s], s);
}

TEST(Compaction_, AfterDetachingListsNothingForTheMeshThatIsGone) {
  Tree t = disk_to_individual(6);
  const NodeId rim = t.add_boundary(NodeId::root);
  const MultiMesh other = t.tree->detach(NodeId{1});
  const auto moved = t.tree->compact();
  ASSERT_EQ(moved.size(), index(rim) + 1U);
  EXPECT_TRUE(moved[1].simplices.empty());
  EXPECT_FALSE(moved[index(rim)].simplices.empty());
}

}  // namespace
}  // namespace multimesh::test
