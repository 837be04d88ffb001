// SPDX-License-Identifier: BSD-3-Clause
// Tests of the judges in dimension 3: homology, manifolds, link condition, types of images.

#include <gtest/gtest.h>

#include <algorithm>

#include "oracle/collapse.hpp"
#include "oracle/homology.hpp"
#include "oracle/image.hpp"
#include "oracle/image_signature.hpp"
#include "oracle/orientation.hpp"
#include "oracle/random_solid_trees.hpp"
#include "oracle/solid_overlay.hpp"
#include "oracle/split.hpp"
#include "oracle/submesh.hpp"

namespace multimesh::oracle {
namespace {

TEST(OracleHomology, KnowsSurfaces) {
  EXPECT_EQ(betti(simplices(base_surface(Surface::kSphere))), (Betti{1, 0, 1, 0}));
  EXPECT_EQ(betti(simplices(base_surface(Surface::kTorus))), (Betti{1, 2, 1, 0}));
  EXPECT_EQ(betti(simplices(base_surface(Surface::kAnnulus))), (Betti{1, 1, 0, 0}));
  EXPECT_EQ(betti(simplices(base_surface(Surface::kMoebius))), (Betti{1, 1, 0, 0}));
}

TEST(OracleHomology, KnowsGraphsAndPoints) {
  EXPECT_EQ(betti(closure({simplex({0, 1}), simplex({1, 2}), simplex({0, 2}), simplex({5})})),
            (Betti{2, 1, 0, 0}));
  EXPECT_EQ(betti(SimplexSet{}), (Betti{0, 0, 0, 0}));
}

// Alexander: what is left of the 3-sphere without a circle is a circle, without a 2-sphere two balls.
TEST(OracleHomology, OfAPairIsThatOfTheComplement) {
  const SimplexSet K = simplices(base_solid(Solid::kSphere));
  const SimplexSet circle = closure({simplex({0, 1}), simplex({1, 2}), simplex({0, 2})});
  EXPECT_EQ(betti(K, circle), (Betti{0, 0, 1, 1}));
  EXPECT_EQ(betti(K, link(K, simplex({0}))), (Betti{0, 0, 0, 2}));
  const Complex ball = base_solid(Solid::kBall);
  EXPECT_EQ(betti(simplices(ball), boundary(ball)), (Betti{0, 0, 0, 1}));
}

TEST(OracleSolids, AreKnown) {
  const auto type = [](Solid kind) {
    const Complex c = base_solid(kind);
    EXPECT_EQ(manifold_error(c), "") << to_string(kind);
    return signature(c);
  };
  EXPECT_EQ(type(Solid::kBall), (Signature{1, 0, 0, 0, 1, 3, 2, 0, 1}));
  EXPECT_EQ(type(Solid::kSphere), (Signature{1, 0, 0, 1, 1, 0}));
  EXPECT_EQ(type(Solid::kSolidTorus), (Signature{1, 1, 0, 0, 1, 3, 0, 0, 1}));
  EXPECT_EQ(type(Solid::kShell), (Signature{1, 0, 1, 0, 1, 6, 2, 0, 1, 2, 0, 1}));
  EXPECT_EQ(type(Solid::kTorus), (Signature{1, 3, 3, 1, 1, 0}));
  EXPECT_EQ(base_solid(Solid::kTorus).facets.size(), 90U);
}

TEST(OracleSolids, ThatAreNoManifoldsAreSeen) {
  const auto is = [](std::vector<Facet> facets) { return manifold_error({3, std::move(facets)}) == ""; };
  EXPECT_TRUE(is({{0, 1, 2, 3}, {0, 1, 2, 4}}));
  EXPECT_FALSE(is({{0, 1, 2, 3}, {0, 1, 2, 4}, {0, 1, 2, 5}})) << "three at a triangle";
  EXPECT_FALSE(is({{0, 1, 2, 3}, {0, 1, 4, 5}})) << "two that share an edge";
  EXPECT_FALSE(is({{0, 1, 2, 3}, {0, 4, 5, 6}})) << "two that share a vertex";
  EXPECT_TRUE(is({{0, 1, 2, 3}, {4, 5, 6, 7}}));
  EXPECT_FALSE(is({{0, 1, 2, 3}, {3, 2, 1, 0}})) << "twice the same";
  EXPECT_FALSE(is({{0, 1, 2, 2}})) << "degenerate";
  Complex cone = base_surface(Surface::kTorus);
  cone.dim = 3;
  for (Facet& f : cone.facets) f[3] = 100;
  EXPECT_FALSE(is(cone.facets)) << "a cone over a torus";
}

TEST(OracleSolids, OrientationAgreesOrIsImpossible) {
  std::mt19937_64 rng(3);
  for (int i = 0; i < 20; ++i) {
    Complex c = random_solid(static_cast<Solid>(i % kNumberOfSolids), 20, rng);
    for (Facet& f : c.facets)
      if (chance(rng, 50)) std::swap(f[1], f[3]);
    EXPECT_TRUE(orient(c));
    Complex again = c;
    EXPECT_TRUE(orient(again));
    EXPECT_EQ(again.facets, c.facets) << "nothing is left to turn";
  }
  Complex band = base_surface(Surface::kMoebius);
  EXPECT_FALSE(orient(band));
}

// The theorem on which check L rests (Dey et al. 1999), and that it is not vacuous.
TEST(OracleSolids, TheLinkConditionKeepsTheType) {
  std::mt19937_64 rng(7);
  std::size_t allowed = 0, forbidden = 0, broken = 0;
  for (int i = 0; i < 25; ++i) {
    const Complex c = random_solid(static_cast<Solid>(i % (kNumberOfSolids - 1)), 10 + pick(rng, 20), rng);
    ASSERT_EQ(manifold_error(c), "");
    const Signature type = signature(c);
    for (const Simplex& e : simplices(c, 1)) {
      const CollapseResult r = collapse({{{c, -1, {}}}}, e.v[0], e.v[1]);
      const bool same = r.valid && signature(r.tree.nodes[0].mesh) == type;
      if (link_condition(c, e.v[0], e.v[1])) {
        ++allowed;
        EXPECT_TRUE(same) << "solid " << i << " edge " << to_string(e);
      } else {
        ++forbidden;
        broken += !same;
      }
    }
  }
  EXPECT_GT(allowed, 100U);
  EXPECT_GT(forbidden, 100U);
  EXPECT_GT(broken, forbidden / 2);
}

/// The type of the image of a child over these simplices.
OverlayType type_in(const Complex& host, const SimplexSet& over, bool host_boundary = false) {
  const TreeNode child = cut_child(0, over);
  return overlay_type(host, {{&child.mesh, child.image}}, host_boundary);
}

/// A ball with room for something inside: every edge is split, several times.
Complex roomy_ball(int rounds = 2) {
  Tree t{{{base_solid(Solid::kBall), -1, {}}}};
  for (int round = 0; round < rounds; ++round)
    for (const Simplex& e : simplices(t.nodes[0].mesh, 1)) t = split(t, e.v[0], e.v[1]).tree;
  return t.nodes[0].mesh;
}

/// An interior vertex whose link has no vertex on the boundary.
Simplex deep_vertex(const Complex& c) {
  const SimplexSet all = simplices(c), rim = boundary(c);
  for (const Simplex& v : of_dimension(all, 0))
    if (!contains(rim, v)) return v;
  return {};
}

TEST(OracleSolidOverlay, TellsSurfacesApart) {
  const Complex host = roomy_ball();
  const SimplexSet all = simplices(host);
  const Simplex deep = deep_vertex(host);
  ASSERT_EQ(deep.n, 1);
  SimplexSet sphere = of_dimension(link(all, deep), 2);
  const OverlayType whole = type_in(host, sphere);
  SimplexSet disk = sphere;
  disk.pop_back();
  const OverlayType holed = type_in(host, disk);
  EXPECT_NE(whole.regions, holed.regions) << "the complement is one piece or two";
  EXPECT_NE(whole.graph, holed.graph) << "a boundary curve or none";
  EXPECT_NE(whole.closures, holed.closures);
  // One more triangle on an edge of the sphere: a non-manifold edge.
  SimplexSet fin = sphere;
  for (const Simplex& t : of_dimension(all, 2))
    if (intersection(closure({t}), closure(sphere)).size() == 3 && fin.size() == sphere.size())
      fin.push_back(t);
  normalize(fin);
  ASSERT_EQ(fin.size(), sphere.size() + 1);
  const OverlayType finned = type_in(host, fin);
  EXPECT_EQ(whole.closures, finned.closures) << "of the same homotopy type";
  EXPECT_NE(whole.graph, finned.graph);
}

TEST(OracleSolidOverlay, SeesContactWithTheBoundaryOnlyIfAsked) {
  const Complex host = roomy_ball(3);
  const SimplexSet rim = boundary(host);
  SimplexSet inside, touching;  // a single edge, off the boundary or with one end there
  for (const Simplex& e : simplices(host, 1)) {
    const SimplexSet common = intersection(closure({e}), rim);
    if (common.empty()) inside = {e};
    if (common.size() == 1) touching = {e};
  }
  ASSERT_FALSE(inside.empty() || touching.empty());
  EXPECT_EQ(type_in(host, inside, false), type_in(host, touching, false));
  EXPECT_NE(type_in(host, inside, true), type_in(host, touching, true));
}

Tree disguised(const Tree& tree) {
  Tree other = tree;
  for (TreeNode& node : other.nodes) {
    const auto corners = static_cast<std::ptrdiff_t>(node.mesh.dim) + 1;
    for (Facet& f : node.mesh.facets) {
      for (int& v : f) v = 1000 - 3 * v;
      std::rotate(f.begin(), f.begin() + 1, f.begin() + corners);
    }
    std::reverse(node.mesh.facets.begin(), node.mesh.facets.end());
    std::map<int, int> image;
    for (const auto& [from, to] : node.image) image[1000 - 3 * from] = 1000 - 3 * to;
    node.image = image;
  }
  return other;
}

TEST(OracleSolidTrees, AreValidAndTheirTypeDoesNotSeeNumbersOrSplits) {
  for (int kind = 0; kind < kNumberOfSolidTreeKinds; ++kind)
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const auto solid = static_cast<Solid>(seed % 4);
      const Tree tree = random_solid_tree(seed, static_cast<SolidTreeKind>(kind), solid);
      SCOPED_TRACE(to_string(static_cast<SolidTreeKind>(kind)) + " seed " + std::to_string(seed));
      ASSERT_EQ(tree_error(tree), "");
      const Tree again = random_solid_tree(seed, static_cast<SolidTreeKind>(kind), solid);
      EXPECT_EQ(again.nodes.back().mesh.facets, tree.nodes.back().mesh.facets);
      std::mt19937_64 rng(seed);
      for (const bool boundary : {true, false}) {
        const SignatureOptions options{boundary, true};
        const TreeSignature before = image_signature(tree, options);
        EXPECT_EQ(difference(before, image_signature(disguised(tree), options)), "");
        const SimplexSet edges = simplices(tree.nodes[0].mesh, 1);
        const Simplex e = edges[pick(rng, edges.size())];
        const SplitResult cut = split(tree, e.v[0], e.v[1]);
        ASSERT_EQ(tree_error(cut.tree), "");
        EXPECT_EQ(difference(before, image_signature(cut.tree, options)), "");
        const CollapseResult back = collapse(cut.tree, e.v[0], cut.vertex[0].at(e));
        ASSERT_TRUE(back.valid) << back.reason;
        EXPECT_EQ(difference(before, image_signature(back.tree, options)), "");
      }
    }
}

TEST(OracleSolidTrees, CollapsesChangeSomethingNowAndThen) {
  std::size_t changed = 0, same = 0;
  for (int kind = 0; kind < kNumberOfSolidTreeKinds; ++kind) {
    const Tree tree = random_solid_tree(5, static_cast<SolidTreeKind>(kind), Solid::kBall);
    const SignatureOptions options{true, true};
    const TreeSignature before = image_signature(tree, options);
    for (const Simplex& e : simplices(tree.nodes[0].mesh, 1))
      ++(judge_collapse(tree, before, e.v[0], e.v[1], options).unchanged ? same : changed);
  }
  EXPECT_GT(changed, 50U);
  EXPECT_GT(same, 20U);
}

}  // namespace
}  // namespace multimesh::oracle
