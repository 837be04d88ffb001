// SPDX-License-Identifier: BSD-3-Clause
// The face split of the tetrahedral mesh against lists of vertex sets.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>

#include "multimesh/faces.hpp"
#include "multimesh/tet/tet_mesh.hpp"
#include "test/support/solids.hpp"

namespace multimesh::test {
namespace {

using Corners = std::array<Index, 4>;
using FaceKey = std::array<Index, 3>;

FaceKey key(Index x, Index y, Index z) {
  FaceKey k{x, y, z};
  std::ranges::sort(k);
  return k;
}

/// The sign of the permutation that sorts, and the sorted corners.
std::pair<Corners, bool> sorted(Corners v) {
  bool even = true;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j + 1 < 4; ++j)
      if (v[j] > v[j + 1]) std::swap(v[j], v[j + 1]), even = !even;
  return {v, even};
}

using Solid = std::map<Corners, bool>;

Solid read(const tet::TetMesh& mesh) {
  Solid all;
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!mesh.is_live(3, t)) continue;
    const Index* v = mesh.corners(t);
    all.insert(sorted({v[0], v[1], v[2], v[3]}));
  }
  return all;
}

std::map<FaceKey, int> values(const tet::TetMesh& mesh, const tet::SimplexProperty<int>& tags) {
  std::map<FaceKey, int> all;
  for (Index t = 0; t < mesh.capacity(3); ++t) {
    if (!mesh.is_live(3, t)) continue;
    for (const Permutation p : faces_around(3, 2, -1)) {
      const Dart d = mesh.reorder(tet::TetMesh::dart(t), p);
      Index v[4];
      mesh.vertices(d, v);
      if (const int* x = mesh.value(tags, d)) all[key(v[0], v[1], v[2])] = *x;
    }
  }
  return all;
}

std::vector<std::string> problems(const tet::TetMesh& mesh) {
  std::vector<std::string> found;
  mesh.check(found);
  return found;
}

TEST(TetMeshSplitFace, ReplacesTheFaceInAListOfVertexSets) {
  std::mt19937 random(3);
  tet::TetMesh mesh(box(2, 2, 2).facets);
  auto& tags = mesh.add_simplex_property<int>(2, "tags");
  auto& from = mesh.add_tet_property<int>("from");
  for (Index t = 0; t < mesh.capacity(3); ++t) from.values[t] = int(t);
  Solid expected = read(mesh);
  std::map<FaceKey, int> expected_tags;
  for (int step = 0; step < 300; ++step) {
    Index t = 0;
    do t = static_cast<Index>(random() % mesh.capacity(3));
    while (!mesh.is_live(3, t));
    const Dart d = mesh.reorder(tet::TetMesh::dart(t), Permutation{static_cast<std::uint8_t>(random() % 24)});
    Index v[4];
    mesh.vertices(d, v);
    if (random() % 2) {
      mesh.set_value(tags, d, step);
      expected_tags[key(v[0], v[1], v[2])] = step;
    }
    const int origin = from.values[t];
    const bool boundary = mesh.is_boundary(d, 2);
    const Dart made = mesh.split_face(d);
    Index w[4];
    mesh.vertices(made, w);
    EXPECT_EQ(made, d);
    EXPECT_TRUE(std::equal(v + 1, v + 4, w + 1));
    const Index m = w[0];
    EXPECT_EQ(mesh.is_boundary(made, 0), boundary);
    for (Solid old = expected; const auto& [corners, even] : old) {
      const auto has = [&](Index x) { return std::ranges::find(corners, x) != corners.end(); };
      if (!has(v[0]) || !has(v[1]) || !has(v[2])) continue;
      expected.erase(corners);
      for (int i = 0; i < 3; ++i) {
        Corners part = corners;
        std::ranges::replace(part, v[i], m);
        const auto [ascending, same] = sorted(part);
        expected[ascending] = even == same;
      }
    }
    if (const auto tag = expected_tags.find(key(v[0], v[1], v[2])); tag != expected_tags.end()) {
      for (int i = 0; i < 3; ++i)
        expected_tags[key(i == 0 ? m : v[0], i == 1 ? m : v[1], i == 2 ? m : v[2])] = tag->second;
      expected_tags.erase(key(v[0], v[1], v[2]));
    }
    DartBuffer star;
    mesh.star(made, 0, star);
    EXPECT_EQ(star.size(), boundary ? 3U : 6U);
    EXPECT_EQ(from.values[mesh.facet(made)], origin);
  }
  EXPECT_EQ(read(mesh), expected);
  EXPECT_EQ(values(mesh, tags), expected_tags);
  EXPECT_EQ(problems(mesh), std::vector<std::string>{});
}

TEST(TetMeshSplitFace, IsRolledBackAmongOtherOperations) {
  std::mt19937 random(5);
  tet::TetMesh mesh(torus3(4).facets);
  auto& tags = mesh.add_simplex_property<int>(2, "tags");
  SplitRecord split;
  CollapseRecord collapse;
  for (int round = 0; round < 60; ++round) {
    const Solid before = read(mesh);
    const auto tags_before = values(mesh, tags);
    const Mesh::Mark mark = mesh.mark();
    for (int step = 0; step < 8; ++step) {
      Index t = 0;
      do t = static_cast<Index>(random() % mesh.capacity(3));
      while (!mesh.is_live(3, t));
      const Dart d =
          mesh.reorder(tet::TetMesh::dart(t), Permutation{static_cast<std::uint8_t>(random() % 24)});
      if (random() % 3 == 0) mesh.set_value(tags, d, step);
      if (const auto choice = random() % 3; choice == 0) {
        mesh.split_edge(d, split);
      } else if (choice == 1 && mesh.link_condition(d)) {
        mesh.collapse_edge(d, collapse);
      } else {
        (void)mesh.split_face(d);
      }
    }
    EXPECT_EQ(problems(mesh), std::vector<std::string>{});
    if (round % 2) {
      mesh.rollback(mark);
      EXPECT_EQ(read(mesh), before);
      EXPECT_EQ(values(mesh, tags), tags_before);
      EXPECT_EQ(problems(mesh), std::vector<std::string>{});
    } else {
      mesh.forget();
    }
  }
}

TEST(TetMeshSplitFace, ThenACollapseIntoTheFarApexSwapsTheFace) {
  tet::TetMesh mesh(tetrahedra({{0, 1, 2, 3}, {0, 1, 2, 4}}).facets);
  Dart d = no_dart;
  for (const Permutation p : faces_around(3, 2, -1)) {
    const Dart face = mesh.reorder(tet::TetMesh::dart(0), p);
    if (!mesh.is_boundary(face, 2)) d = face;
  }
  const Dart made = mesh.split_face(d);                             // (m,y,z,w)
  const Dart beyond = mesh.reorder(made, permutation(0, 3, 1, 2));  // (m,w,y,z)
  ASSERT_TRUE(mesh.link_condition(beyond));
  CollapseRecord record;
  mesh.collapse_edge(beyond, record);
  EXPECT_EQ(problems(mesh), std::vector<std::string>{});
  const Solid all = read(mesh);
  EXPECT_EQ(all.size(), 3U);
  for (const auto& [v, even] : all) {
    EXPECT_NE(std::ranges::find(v, Index{3}), v.end());
    EXPECT_NE(std::ranges::find(v, Index{4}), v.end());
  }
}

}  // namespace
}  // namespace multimesh::test
