// SPDX-License-Identifier: BSD-3-Clause
// The local operations of one mesh, on every edge: results against brute force over vertex sets, and the
// guarantees about dart names on which the maps rely.
#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/domains/make_mesh.hpp"
#include "oracle/collapse.hpp"
#include "oracle/random_solid.hpp"
#include "oracle/split.hpp"
#include "test/core/bridge.hpp"
#include "test/core/mesh_cases.hpp"

namespace multimesh::test {
namespace {

oracle::Tree alone(const Mesh& mesh) {
  return {{{complex_of(mesh), -1, {}}}};
}

std::vector<Index> vertices(const Mesh& mesh, Dart d) {
  std::vector<Index> v(4);
  mesh.vertices(d, v.data());
  v.resize(static_cast<std::size_t>(mesh.dimension()) + 1);
  return v;
}

bool has_facet(const DartBuffer& darts, const Mesh& mesh, Index f) {
  return std::any_of(darts.begin(), darts.end(), [&](Dart d) { return mesh.facet(d) == f; });
}

/// The vertices and the facet of every live dart, by code.
struct OldDart {
  Dart dart;
  Index facet;
  std::vector<Index> vertices;
};
std::vector<OldDart> remember(const Mesh& mesh) {
  std::vector<OldDart> all;
  for (const Dart d : all_darts(mesh)) all.push_back({d, mesh.facet(d), vertices(mesh, d)});
  return all;
}

/// Calls `test` with every edge dart; the mesh is put back after each.
template <class Test>
void on_every_edge(Mesh& mesh, const Test& test) {
  if (mesh.dimension() == 0) return;
  // All orderings of tetrahedra are too many: every seventh, which is prime to their number.
  const DartBuffer darts = all_darts(mesh);
  const std::size_t step = mesh.dimension() == 3 ? 7 : 1;
  for (std::size_t i = 0; i < darts.size(); i += step) {
    const Dart e = darts[i];
    const auto before = plain(alone(mesh));
    const auto mark = mesh.mark();
    SCOPED_TRACE("dart " + std::to_string(code(e)));
    test(e);
    std::vector<std::string> problems;
    mesh.check(problems);
    ASSERT_EQ(problems, std::vector<std::string>{});
    mesh.rollback(mark);
    ASSERT_EQ(plain(alone(mesh)), before);
  }
}

class MeshOperations : public testing::TestWithParam<MeshCase> {};

TEST_P(MeshOperations, LinkConditionIsThatOfTheVertexSets) {
  const auto mesh = GetParam().make();
  if (mesh->dimension() == 0) return;
  const auto complex = complex_of(*mesh);
  for (const Dart e : all_darts(*mesh)) {
    const auto v = vertices(*mesh, e);
    EXPECT_EQ(mesh->link_condition(e),
              oracle::link_condition(complex, static_cast<int>(v[0]), static_cast<int>(v[1])))
        << v[0] << "-" << v[1];
  }
}

TEST_P(MeshOperations, SplitIsThatOfTheVertexSets) {
  const auto mesh = GetParam().make();
  on_every_edge(*mesh, [&](Dart e) {
    const auto v = vertices(*mesh, e);
    const auto wanted = oracle::split(alone(*mesh), static_cast<int>(v[0]), static_cast<int>(v[1]));
    SplitRecord r;
    mesh->split_edge(e, r);
    const int c = static_cast<int>(r.vertex);
    EXPECT_EQ(plain(alone(*mesh)), plain(wanted.tree, {{{wanted.vertex[0].begin()->second, c}}}));
    EXPECT_EQ(r.a, v[0]);
    EXPECT_EQ(r.b, v[1]);
    EXPECT_EQ(mesh->vertex(r.at_a), v[0]);
    EXPECT_EQ(vertices(*mesh, r.at_a)[1], r.vertex);
  });
}

TEST_P(MeshOperations, SplitTellsEveryDartThatGotAnotherName) {
  const auto mesh = GetParam().make();
  on_every_edge(*mesh, [&](Dart e) {
    DartBuffer over;
    mesh->star(e, 1, over);
    const auto old = remember(*mesh);
    std::vector<Index> split_facets;
    for (const Dart t : over) split_facets.push_back(mesh->facet(t));
    SplitRecord r;
    mesh->split_edge(e, r);
    ASSERT_EQ(r.facets.size(), split_facets.size());
    for (const OldDart& o : old) {
      const auto halves =
          std::find_if(r.facets.begin(), r.facets.end(), [&](const auto& h) { return h.old == o.facet; });
      if (halves == r.facets.end()) {
        EXPECT_EQ(vertices(*mesh, o.dart), o.vertices) << "a facet that was not split";
        EXPECT_EQ(mesh->facet(o.dart), o.facet);
        continue;
      }
      EXPECT_TRUE(halves->at_a == halves->old || halves->at_b == halves->old);
      for (const End end : {End::a, End::b}) {
        const Dart now = mesh->after_split(r, o.dart, end);
        auto wanted = o.vertices;
        std::replace(wanted.begin(), wanted.end(), end == End::a ? r.b : r.a, r.vertex);
        ASSERT_TRUE(mesh->is_dart(now));
        EXPECT_EQ(vertices(*mesh, now), wanted);
        EXPECT_EQ(mesh->facet(now), end == End::a ? halves->at_a : halves->at_b);
      }
    }
  });
}

TEST_P(MeshOperations, CollapseIsThatOfTheVertexSets) {
  const auto mesh = GetParam().make();
  on_every_edge(*mesh, [&](Dart e) {
    if (!mesh->link_condition(e)) return;
    const auto v = vertices(*mesh, e);
    const auto wanted = oracle::collapse(alone(*mesh), static_cast<int>(v[1]), static_cast<int>(v[0]));
    ASSERT_TRUE(wanted.valid) << wanted.reason;
    CollapseRecord r;
    mesh->collapse_edge(e, r);
    EXPECT_EQ(plain(alone(*mesh)), plain(wanted.tree));
    EXPECT_EQ(r.dead, v[0]);
    EXPECT_EQ(r.survivor, v[1]);
    EXPECT_FALSE(mesh->is_live(0, v[0]));
    ASSERT_TRUE(mesh->is_dart(r.at_survivor));
    EXPECT_EQ(mesh->vertex(r.at_survivor), v[1]);
  });
}

TEST_P(MeshOperations, CollapseTellsEveryDartThatGotAnotherName) {
  const auto mesh = GetParam().make();
  const int d = mesh->dimension();
  on_every_edge(*mesh, [&](Dart e) {
    if (!mesh->link_condition(e)) return;
    CollapseRegion region;
    mesh->collapse_region(e, region);
    DartBuffer over;
    mesh->star(e, 1, over);
    ASSERT_EQ(region.dead.size(), over.size());
    for (const Dart t : over) EXPECT_TRUE(has_facet(region.dead, *mesh, mesh->facet(t)));
    for (const Dart t : region.dead) EXPECT_EQ(vertices(*mesh, t)[0], mesh->vertex(e)) << "darts (a, b, ...)";
    const auto old = remember(*mesh);
    std::vector<Index> dead, renamed;
    for (const Dart t : region.dead) dead.push_back(mesh->facet(t));
    for (const Dart t : region.renamed) renamed.push_back(mesh->facet(t));
    std::sort(renamed.begin(), renamed.end());
    EXPECT_EQ(std::adjacent_find(renamed.begin(), renamed.end()), renamed.end()) << "each facet once";
    CollapseRecord r;
    mesh->collapse_edge(e, r);
    for (const OldDart& o : old) {
      const Dart now = mesh->after_collapse(r, o.dart);
      auto wanted = o.vertices;
      std::replace(wanted.begin(), wanted.end(), r.dead, r.survivor);
      if (std::find(dead.begin(), dead.end(), o.facet) == dead.end()) {
        ASSERT_TRUE(mesh->is_dart(now));
        EXPECT_EQ(vertices(*mesh, now), wanted);
        EXPECT_EQ(mesh->facet(now), o.facet);
        if (now != o.dart) {
          EXPECT_TRUE(std::binary_search(renamed.begin(), renamed.end(), o.facet));
        }
        continue;
      }
      EXPECT_FALSE(mesh->is_live(d, o.facet));
      for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {  // the leading vertices that stay apart
        const auto last = wanted.begin() + static_cast<std::ptrdiff_t>(k);
        if (std::count(wanted.begin(), last + 1, r.survivor) > 1) break;
        const auto got = vertices(*mesh, now);
        ASSERT_TRUE(mesh->is_dart(now));
        EXPECT_TRUE(std::equal(wanted.begin(), last + 1, got.begin()));
      }
    }
  });
}

TEST_P(MeshOperations, FlipReplacesTheDiagonalAndKeepsTheOuterDarts) {
  const auto mesh = GetParam().make();
  if (mesh->dimension() != 2) return;
  const auto edges = oracle::simplices(complex_of(*mesh), 1);
  on_every_edge(*mesh, [&](Dart e) {
    const Dart across = mesh->switch_dart(e, 2);
    if (across == no_dart) {
      EXPECT_FALSE(mesh->can_flip(e));
      return;
    }
    const auto left = vertices(*mesh, e), right = vertices(*mesh, across);
    const Index a = left[0], b = left[1], l = left[2], r = right[2];
    const bool taken =
        l == r || oracle::contains(edges, oracle::simplex({static_cast<int>(l), static_cast<int>(r)}));
    EXPECT_EQ(mesh->can_flip(e), !taken);
    if (taken) return;
    auto wanted = oracle::facet_set(complex_of(*mesh));
    for (const Index end : {a, b})
      for (const bool was : {true, false}) {
        const auto s =
            was ? oracle::simplex(
                      {static_cast<int>(a), static_cast<int>(b), static_cast<int>(end == a ? l : r)})
                : oracle::simplex({static_cast<int>(l), static_cast<int>(r), static_cast<int>(end)});
        was ? void(std::erase(wanted, s)) : wanted.push_back(s);
      }
    oracle::normalize(wanted);
    std::vector<OldDart> outer;
    for (const Dart side : {e, across})
      for (const Permutation p : {edge_ax, edge_bx})
        outer.push_back({mesh->reorder(side, p), 0, vertices(*mesh, mesh->reorder(side, p))});
    mesh->flip_edge(e);
    EXPECT_EQ(oracle::facet_set(complex_of(*mesh)), wanted);
    for (const OldDart& o : outer) {
      ASSERT_TRUE(mesh->is_dart(o.dart));
      EXPECT_EQ(vertices(*mesh, o.dart)[0], o.vertices[0]);
      EXPECT_EQ(vertices(*mesh, o.dart)[1], o.vertices[1]);
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Meshes, MeshOperations, testing::ValuesIn(mesh_cases()),
                         [](const auto& mesh_case) { return mesh_case.param.name; });

// Small complexes are where link conditions fail in all possible ways.
TEST(LinkCondition, IsThatOfTheVertexSetsOnRandomSurfaces) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    std::mt19937_64 random(seed);
    const auto kind = static_cast<oracle::Surface>(seed % 5);  // the Moebius band is not orientable
    const auto list = oriented(oracle::random_surface(kind, 1 + seed % 12, random));
    ASSERT_TRUE(list);
    const auto mesh = make_mesh(*list);
    const auto complex = complex_of(*mesh);
    for (const Dart e : all_darts(*mesh)) {
      const auto v = vertices(*mesh, e);
      ASSERT_EQ(mesh->link_condition(e),
                oracle::link_condition(complex, static_cast<int>(v[0]), static_cast<int>(v[1])))
          << "seed " << seed << ", edge " << v[0] << "-" << v[1];
    }
  }
}

TEST(LinkCondition, IsThatOfTheVertexSetsOnRandomSolids) {
  std::size_t allowed = 0, refused = 0;
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937_64 random(seed);
    const auto kind = static_cast<oracle::Solid>(seed % (oracle::kNumberOfSolids - 1));
    const auto list = oriented(oracle::random_solid(kind, 1 + seed % 30, random));
    ASSERT_TRUE(list);
    const auto mesh = make_mesh(*list);
    const auto complex = complex_of(*mesh);
    for (const Dart side : simplices_of(*mesh, 1))
      for (const Dart e : {side, mesh->switch_dart(side, 0), mesh->switch_dart(side, 2)}) {
        const auto v = vertices(*mesh, e);
        const bool wanted = oracle::link_condition(complex, static_cast<int>(v[0]), static_cast<int>(v[1]));
        ++(wanted ? allowed : refused);
        ASSERT_EQ(mesh->link_condition(e), wanted) << "seed " << seed << ", edge " << v[0] << "-" << v[1];
      }
  }
  EXPECT_GT(allowed, 1000U);
  EXPECT_GT(refused, 1000U);
}

}  // namespace
}  // namespace multimesh::test
