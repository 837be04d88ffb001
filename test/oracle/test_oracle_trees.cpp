// SPDX-License-Identifier: BSD-3-Clause
// Tests of the judges on trees: maps, signatures of images, collapse, split, the tag-based link condition.

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/collapse.hpp"
#include "oracle/image.hpp"
#include "oracle/image_signature.hpp"
#include "oracle/random_trees.hpp"
#include "oracle/split.hpp"
#include "oracle/submesh.hpp"
#include "oracle/vivodtzev.hpp"

namespace multimesh::oracle {
namespace {

// 12-13-14-15     A disk of 18 facets, every square cut from lower left to upper right.
//  8--9-10-11
//  4--5--6--7
//  0--1--2--3
Complex grid_disk() {
  Complex c{2, {}};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const int v = 4 * i + j;
      c.facets.push_back({v, v + 1, v + 5});
      c.facets.push_back({v, v + 5, v + 4});
    }
  }
  return c;
}

SimplexSet edge_set(std::initializer_list<std::array<int, 2>> edges) {
  SimplexSet set;
  for (const auto& e : edges) set.push_back(simplex({e[0], e[1]}));
  normalize(set);
  return set;
}

std::vector<std::size_t> all_facets(const Complex& c) {
  std::vector<std::size_t> all(c.facets.size());
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = f;
  return all;
}

Tree with_curve(const SimplexSet& edges) {
  const Complex root = grid_disk();
  return {{{root, -1, {}}, curve_child(root, 0, edges)}};
}

Tree with_uv(const SimplexSet& cuts) {
  const Complex root = grid_disk();
  return {{{root, -1, {}}, surface_child(root, 0, all_facets(root), cuts)}};
}

Judgement judge(const Tree& tree, int a, int b, const SignatureOptions& options = {}) {
  return judge_collapse(tree, image_signature(tree, options), a, b, options);
}

TEST(OracleImage, SeamEdgesHaveTwoPreimagesAndSlitEndsOne) {
  const Tree tree = with_uv(edge_set({{5, 6}, {6, 10}}));  // a slit inside: ends 5 and 10
  EXPECT_EQ(tree_error(tree), "");
  EXPECT_EQ(preimages(tree, 1, 0, simplex({5, 6})).size(), 2U);
  EXPECT_EQ(preimages(tree, 1, 0, simplex({6})).size(), 2U);
  EXPECT_EQ(preimages(tree, 1, 0, simplex({5})).size(), 1U);
  EXPECT_EQ(preimages(tree, 1, 0, simplex({5, 10})).size(), 1U);
  EXPECT_EQ(signature(tree.nodes[1].mesh), (Signature{0, 2, 1}));  // the slit is a hole of the child
  EXPECT_EQ(image(tree, 1, 0), simplices(tree.nodes[0].mesh));
  const SeamGraph seam = seam_graph(tree, 1, 0);
  EXPECT_EQ(seam.edges, edge_set({{5, 6}, {6, 10}}));
  EXPECT_EQ(seam.corners, (std::vector<int>{5, 10}));
}

TEST(OracleImage, ASlitOfOneEdgeIsNoCut) {
  const Tree tree = with_uv(edge_set({{5, 6}}));
  EXPECT_EQ(tree_error(tree), "");
  EXPECT_TRUE(seam_graph(tree, 1, 0).edges.empty());
}

TEST(OracleImage, CurvesAreCutAtJunctionsOnly) {
  const Tree star_shaped = with_curve(edge_set({{5, 6}, {5, 4}, {5, 9}, {9, 13}}));
  EXPECT_EQ(preimages(star_shaped, 1, 0, simplex({5})).size(), 3U);
  EXPECT_EQ(number_of_components(star_shaped.nodes[1].mesh), 3);
  const Tree closed = with_curve(edge_set({{5, 6}, {6, 10}, {5, 10}}));
  EXPECT_EQ(signature(closed.nodes[1].mesh), (Signature{0, 0, 1}));
}

TEST(OracleImage, EachDefectOfAMapIsReported) {
  const Tree good = with_curve(edge_set({{5, 6}, {6, 10}}));
  ASSERT_EQ(tree_error(good), "");
  const Complex& child = good.nodes[1].mesh;
  const Complex& parent = good.nodes[0].mesh;
  const int five = preimages(good, 1, 0, simplex({5}))[0].v[0];
  std::map<int, int> map = good.nodes[1].image;
  map.erase(five);
  EXPECT_NE(map_error(child, parent, map), "");
  map[five] = 6;  // degenerate
  EXPECT_NE(map_error(child, parent, map), "");
  map[five] = 15;  // no edge of the parent
  EXPECT_NE(map_error(child, parent, map), "");
  map[five] = 10;  // not injective
  EXPECT_NE(map_error(child, parent, map), "");
  map[five] = 5;
  EXPECT_EQ(map_error(child, parent, map), "");
  map[99] = 5;  // not a vertex
  EXPECT_NE(map_error(child, parent, map), "");
}

TEST(OracleImage, MapsCompose) {
  Tree tree = with_curve(edge_set({{5, 6}, {6, 10}, {10, 11}}));
  tree.nodes.push_back(
      curve_child(tree.nodes[1].mesh, 1, edges_over(tree, 1, 0, edge_set({{6, 10}, {10, 11}})), {}));
  EXPECT_EQ(tree_error(tree), "");
  EXPECT_EQ(image(tree, 2, 0), closure(edge_set({{6, 10}, {10, 11}})));
  EXPECT_THROW(map_to(tree, 0, 2), std::logic_error);
}

/// The same tree with other vertex numbers and another order of facets.
Tree disguised(const Tree& tree) {
  Tree other = tree;
  for (TreeNode& node : other.nodes) {
    for (auto& f : node.mesh.facets) {
      for (int& v : f) v = 1000 - 3 * v;
      std::rotate(f.begin(), f.begin() + 1, f.begin() + node.mesh.dim + 1);
    }
    std::reverse(node.mesh.facets.begin(), node.mesh.facets.end());
    std::map<int, int> image;
    for (const auto& [from, to] : node.image) image[1000 - 3 * from] = 1000 - 3 * to;
    node.image = image;
  }
  return other;
}

TEST(OracleSignature, DoesNotSeeNumbersOrOrder) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const Tree tree = random_tree(seed);
    for (bool boundary : {true, false}) {
      const SignatureOptions options{boundary, true};
      EXPECT_EQ(difference(image_signature(tree, options), image_signature(disguised(tree), options)), "")
          << seed;
    }
  }
}

TEST(OracleSignature, SeesWhereACurveLies) {
  const auto type = [](const SimplexSet& edges, bool boundary) {
    return image_signature(with_curve(edges), {boundary, false});
  };
  const SimplexSet inside = edge_set({{5, 6}});
  const SimplexSet touching = edge_set({{4, 5}});
  EXPECT_NE(type(inside, true), type(touching, true));
  EXPECT_EQ(type(inside, false), type(touching, false));
  const SimplexSet across = edge_set({{4, 5}, {5, 6}, {6, 7}});  // cuts the disk in two
  const SimplexSet along = edge_set({{0, 1}, {1, 2}});
  EXPECT_NE(type(across, true), type(along, true));
  EXPECT_NE(type(across, true), type(touching, true));
  EXPECT_EQ(type(inside, true), type(edge_set({{5, 6}, {6, 10}}), true));
  const SimplexSet closed = edge_set({{5, 6}, {6, 10}, {5, 10}});
  EXPECT_NE(type(inside, false), type(closed, false));
}

TEST(OracleSignature, SeesSeamsBranch) {
  const TreeSignature straight = image_signature(with_uv(edge_set({{4, 5}, {5, 6}, {6, 10}})));
  const TreeSignature branched = image_signature(with_uv(edge_set({{4, 5}, {5, 6}, {5, 9}})));
  EXPECT_EQ(straight, image_signature(with_uv(edge_set({{4, 5}, {5, 6}}))));
  EXPECT_NE(straight, branched);
  EXPECT_EQ(straight.parts[1].words, branched.parts[1].words);  // the child is a disk both times
}

TEST(OracleSignature, SeesContactOfSiblingsOnlyWhenAsked) {
  const auto type = [](const SimplexSet& one, const SimplexSet& two, bool siblings) {
    const Complex root = grid_disk();
    const Tree tree{{{root, -1, {}}, curve_child(root, 0, one), curve_child(root, 0, two)}};
    return image_signature(tree, {false, siblings});
  };
  const SimplexSet one = edge_set({{4, 5}});
  EXPECT_EQ(type(one, edge_set({{5, 6}}), false), type(one, edge_set({{6, 7}}), false));
  EXPECT_NE(type(one, edge_set({{5, 6}}), true), type(one, edge_set({{6, 7}}), true));
}

TEST(OracleCollapse, KeepsAnUntouchedImage) {
  const Tree tree = with_curve(edge_set({{5, 6}, {6, 10}}));
  EXPECT_TRUE(judge(tree, 5, 6).unchanged) << judge(tree, 5, 6).reason;
  EXPECT_TRUE(judge(tree, 12, 13).unchanged) << judge(tree, 12, 13).reason;
  const CollapseResult result = collapse(tree, 5, 6);
  EXPECT_EQ(result.tree.nodes[0].mesh.facets.size(), 16U);
  EXPECT_EQ(image(result.tree, 1, 0), closure(edge_set({{5, 10}})));
}

TEST(OracleCollapse, SeesGluedEndsOfACurve) {
  // The ends 5 and 10 of a path of three edges are neighbours; nothing in the child says so.
  const Tree tree = with_curve(edge_set({{5, 4}, {4, 8}, {8, 9}, {9, 10}}));
  const Judgement judgement = judge(tree, 5, 10);
  EXPECT_TRUE(judgement.valid);
  EXPECT_FALSE(judgement.unchanged);
  EXPECT_NE(judgement.reason.find("graph of node 1 in node 0"), std::string::npos);
}

TEST(OracleCollapse, SeesTwoEdgesOverOne) {
  // All three sides of the facet 5 6 10, and more edges so that each is a chain of its own.
  const Tree tree = with_curve(edge_set({{5, 6}, {6, 10}, {5, 10}, {4, 5}, {6, 7}, {10, 14}}));
  const Judgement judgement = judge(tree, 5, 6);
  EXPECT_FALSE(judgement.valid);
  EXPECT_NE(judgement.reason.find("two facets have the image"), std::string::npos) << judgement.reason;
}

TEST(OracleCollapse, SeesAMeshDisappear) {
  const Judgement judgement = judge(with_curve(edge_set({{5, 6}})), 5, 6);
  EXPECT_FALSE(judgement.valid);
  EXPECT_EQ(judgement.reason, "node 1: no facets");
}

// 3---2
// | / |   The ear 3 leaves a dangling edge behind when the side 0 2 is collapsed.
// 0---1---4   (and a facet 1 4 2)
TEST(OracleCollapse, SeesADanglingEdge) {
  const Tree tree{{{{2, {{0, 1, 2}, {0, 2, 3}, {1, 4, 2}}}, -1, {}}}};
  const CollapseResult result = collapse(tree, 0, 2);
  EXPECT_FALSE(result.valid);
  EXPECT_EQ(result.reason, "node 0: vertex 3 is in no facet any more");
}

TEST(OracleCollapse, SeesASlitOfTwoEdgesClose) {
  const Judgement judgement = judge(with_uv(edge_set({{5, 6}, {6, 10}})), 5, 6);
  EXPECT_FALSE(judgement.unchanged);
}

TEST(OracleCollapse, SeesADanglingSeamVanish) {
  // The seam branch at 5-6 hangs on a seam across the disk; the child stays what it is.
  const Tree tree = with_uv(edge_set({{4, 5}, {5, 9}, {9, 13}, {5, 6}}));
  const Judgement judgement = judge(tree, 5, 6);
  EXPECT_TRUE(judgement.valid) << judgement.reason;
  EXPECT_FALSE(judgement.unchanged);
}

TEST(OracleSplit, NeverChangesAnything) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Tree tree = random_tree(seed);
    const SignatureOptions options{true, true};
    const TreeSignature before = image_signature(tree, options);
    for (const Simplex& e : simplices(tree.nodes[0].mesh, 1)) {
      const SplitResult result = split(tree, e.v[0], e.v[1]);
      ASSERT_EQ(tree_error(result.tree), "") << seed;
      EXPECT_EQ(difference(before, image_signature(result.tree, options)), "") << seed << ' ' << to_string(e);
    }
  }
}

std::vector<SimplexSet> facet_sets(const Tree& tree) {
  std::vector<SimplexSet> sets;
  for (const TreeNode& node : tree.nodes) sets.push_back(facet_set(node.mesh));
  return sets;
}

TEST(OracleSplit, CollapseOfTheNewEdgeUndoesIt) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Tree tree = random_tree(seed);
    std::mt19937_64 rng(seed);
    const Simplex e = random_root_edge(tree, rng);
    const SplitResult result = split(tree, e.v[0], e.v[1]);
    const int fresh = result.vertex[0].at(e);
    const CollapseResult undone = collapse(result.tree, e.v[0], fresh);
    EXPECT_TRUE(undone.valid) << seed << ' ' << undone.reason;
    EXPECT_EQ(facet_sets(undone.tree), facet_sets(tree)) << seed;  // new vertices are the larger ones
  }
}

TEST(OracleRandomTrees, AreValidDeterministicAndOfTheAskedKind) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Tree tree = random_tree(seed);
    EXPECT_EQ(tree_error(tree), "") << seed;
    EXPECT_LE(tree.nodes[0].mesh.facets.size(), 31U);
    EXPECT_EQ(facet_sets(tree), facet_sets(random_tree(seed)));
    EXPECT_GE(tree.nodes.size(), 2U);
  }
  EXPECT_EQ(random_tree(1, TreeKind::kMixed, Surface::kTorus).nodes.size(), 5U);
  EXPECT_EQ(random_tree(1, TreeKind::kUvSeam, Surface::kDisk).nodes[2].parent, 1);
  EXPECT_EQ(random_tree(1, TreeKind::kUvRootSeam, Surface::kDisk).nodes[2].parent, 0);
}

TEST(OracleRandomTrees, SeamChildrenLieOverTheSeamGraph) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    for (TreeKind kind : {TreeKind::kUvSeam, TreeKind::kUvRootSeam}) {
      const Tree tree = random_tree(seed, kind, static_cast<Surface>(seed % kNumberOfSurfaces));
      EXPECT_EQ(image(tree, 2, 0), closure(seam_graph(tree, 1, 0).edges)) << seed;
    }
  }
}

bool tags_allow(const SimplexSet& edges, int a, int b, Strata strata, const SimplexSet& points = {}) {
  return substructure_link_condition({grid_disk(), edges, points}, a, b, strata);
}

TEST(OracleVivodtzev, WithoutTagsIsTheLinkCondition) {
  const Complex disk = grid_disk();
  for (const Simplex& e : simplices(disk, 1)) {
    EXPECT_EQ(tags_allow({}, e.v[0], e.v[1], Strata::kSeparate), link_condition(disk, e.v[0], e.v[1]));
  }
}

TEST(OracleVivodtzev, KnownCases) {
  const SimplexSet arc = edge_set({{5, 4}, {4, 8}, {8, 9}, {9, 10}});
  for (Strata strata : {Strata::kJoint, Strata::kSeparate}) {
    EXPECT_FALSE(tags_allow(arc, 5, 10, strata));                                  // would close it
    EXPECT_FALSE(tags_allow(edge_set({{5, 6}}), 5, 6, strata));                    // would lose it
    EXPECT_FALSE(tags_allow(edge_set({{5, 6}, {6, 10}, {5, 10}}), 5, 6, strata));  // a loop of three
    EXPECT_TRUE(tags_allow(edge_set({{5, 6}, {6, 10}}), 5, 6, strata));
    EXPECT_FALSE(tags_allow(edge_set({{5, 6}, {6, 10}}), 5, 6, strata, {simplex({6})}));
  }
  // 5 is inside, 4 on the boundary: the tagged point 5 would come to lie on the boundary.
  EXPECT_FALSE(tags_allow(edge_set({{5, 6}, {6, 10}}), 4, 5, Strata::kJoint));
  EXPECT_TRUE(tags_allow(edge_set({{5, 6}, {6, 10}}), 4, 5, Strata::kSeparate));
}

/// Asks every edge of one-curve trees and compares with identification.
template <typename Expect>
void for_each_candidate(Strata strata, const SignatureOptions& options, Expect expect) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Tree tree = random_tree(seed, TreeKind::kCurve, static_cast<Surface>(seed % kNumberOfSurfaces));
    const TaggedSurface tagged{tree.nodes[0].mesh, of_dimension(image(tree, 1, 0), 1), {}};
    const TreeSignature before = image_signature(tree, options);
    for (const Simplex& e : simplices(tagged.mesh, 1)) {
      const bool allowed = substructure_link_condition(tagged, e.v[0], e.v[1], strata);
      expect(allowed, judge_collapse(tree, before, e.v[0], e.v[1], options), seed, e);
    }
  }
}

// Both directions: on one embedded curve the condition is necessary and sufficient.
TEST(OracleVivodtzev, SeparateStrataAllowExactlyWhatKeepsTheImage) {
  for_each_candidate(Strata::kSeparate, {false, false},
                     [](bool allowed, const Judgement& j, std::uint64_t seed, const Simplex& e) {
                       EXPECT_EQ(allowed, j.unchanged) << seed << ' ' << to_string(e) << ' ' << j.reason;
                     });
}

TEST(OracleVivodtzev, WhatJointStrataAllowKeepsTheContactWithTheBoundaryToo) {
  int allowed_count = 0;
  for_each_candidate(Strata::kJoint, {true, false},
                     [&](bool allowed, const Judgement& j, std::uint64_t seed, const Simplex& e) {
                       allowed_count += allowed ? 1 : 0;
                       EXPECT_TRUE(!allowed || j.unchanged) << seed << ' ' << to_string(e) << ' ' << j.reason;
                     });
  EXPECT_GT(allowed_count, 500);  // not vacuous
}

}  // namespace
}  // namespace multimesh::oracle
