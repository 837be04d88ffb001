// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/random_trees.hpp"

#include <array>
#include <utility>

#include "oracle/image.hpp"
#include "oracle/submesh.hpp"

namespace multimesh::oracle {

std::string to_string(TreeKind kind) {
  static const std::array<const char*, kNumberOfTreeKinds> kNames{
      "curve",    "two curves",  "uv",    "uv patch", "uv, seam of root", "uv, seam of uv", "curve of curve",
      "uv of uv", "curve of uv", "mixed", "points",   "points of uv",     "points of curve"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string to_string(Surface kind) {
  static const std::array<const char*, kNumberOfSurfaces> kNames{"disk",  "sphere",      "annulus",
                                                                 "torus", "holed torus", "Moebius band"};
  return kNames[static_cast<std::size_t>(kind)];
}

namespace {

void add_scattered(const SimplexSet& all, std::mt19937_64& rng, SimplexSet& edges) {
  const std::size_t percent = 5 + pick(rng, 30);
  for (const Simplex& e : all) {
    if (chance(rng, percent)) edges.push_back(e);
  }
}

void add_walk(const SimplexSet& all, std::mt19937_64& rng, SimplexSet& edges) {
  const SimplexSet points = of_dimension(closure(all), 0);
  int at = points[pick(rng, points.size())].v[0];
  for (std::size_t steps = 1 + pick(rng, 6); steps > 0; --steps) {
    const SimplexSet around = star(all, simplex({at}));
    const Simplex e = around[pick(rng, around.size())];
    edges.push_back(e);
    at = minus(e, simplex({at})).v[0];
  }
}

void add_ring(const Complex& mesh, std::mt19937_64& rng, SimplexSet& edges) {
  const SimplexSet all = simplices(mesh);
  const SimplexSet points = of_dimension(all, 0);
  const SimplexSet ring = of_dimension(link(all, points[pick(rng, points.size())]), 1);
  edges.insert(edges.end(), ring.begin(), ring.end());
}

}  // namespace

SimplexSet random_edges(const Complex& mesh, std::mt19937_64& rng) {
  const SimplexSet all = simplices(mesh, 1);
  SimplexSet edges;
  while (edges.empty()) {
    if (chance(rng, 30)) add_scattered(all, rng, edges);
    if (chance(rng, 25)) add_ring(mesh, rng, edges);
    for (std::size_t walks = pick(rng, 3); walks > 0; --walks) add_walk(all, rng, edges);
  }
  normalize(edges);
  return edges;
}

std::vector<int> random_points(const Complex& mesh, std::mt19937_64& rng) {
  const std::vector<int> all = vertices(mesh);
  const std::size_t percent = 5 + pick(rng, 40);
  std::vector<int> some;
  for (const int v : all)
    if (chance(rng, percent)) some.push_back(v);
  if (some.empty()) some.push_back(all[pick(rng, all.size())]);
  return some;
}

Simplex random_root_edge(const Tree& tree, std::mt19937_64& rng) {
  const SimplexSet edges = simplices(tree.nodes[0].mesh, 1);
  return edges[pick(rng, edges.size())];
}

namespace {

/// Builds one tree; every function adds a node under `parent` and returns its index.
class TreeBuilder {
 public:
  TreeBuilder(Complex root, std::mt19937_64& rng) : rng_(rng) {
    tree_.nodes.push_back({std::move(root), -1, {}});
  }

  Tree take() { return std::move(tree_); }

  int curve(int parent) { return add(curve_child(mesh(parent), parent, random_edges(mesh(parent), rng_))); }

  int points(int parent) { return add(point_child(parent, random_points(mesh(parent), rng_))); }

  /// Some edges of a curve, cut at some vertices.
  int sub_curve(int parent) {
    std::vector<int> cut_at;
    for (int v : vertices(mesh(parent))) {
      if (chance(rng_, 20)) cut_at.push_back(v);
    }
    SimplexSet edges = facet_set(mesh(parent));
    if (chance(rng_, 70)) edges = random_edges(mesh(parent), rng_);
    return add(curve_child(mesh(parent), parent, edges, cut_at));
  }

  int uv(int parent, bool patch) {
    std::vector<std::size_t> facets;
    const std::size_t percent = patch ? 50 + pick(rng_, 45) : 100;
    for (std::size_t f = 0; f < mesh(parent).facets.size(); ++f) {
      if (chance(rng_, percent)) facets.push_back(f);
    }
    if (facets.empty()) facets.push_back(0);
    return add(surface_child(mesh(parent), parent, facets, random_edges(mesh(parent), rng_)));
  }

  /// The seam graph of `node` in the root as a child of `parent`; nothing when it is empty.
  int seam(int node, int parent) {
    const SeamGraph graph = seam_graph(tree_, node, 0);
    if (graph.edges.empty()) return -1;
    return add(curve_child(mesh(parent), parent, edges_over(tree_, parent, 0, graph.edges),
                           vertices_over(tree_, parent, 0, graph.corners)));
  }

  /// A full UV child or a patch.
  int any_uv() { return uv(0, chance(rng_, 30)); }

  bool coin() { return chance(rng_, 50); }

 private:
  const Complex& mesh(int node) const { return tree_.nodes[static_cast<std::size_t>(node)].mesh; }

  int add(TreeNode node) {
    tree_.nodes.push_back(std::move(node));
    return static_cast<int>(tree_.nodes.size()) - 1;
  }

  std::mt19937_64& rng_;
  Tree tree_;
};

/// Whether all wanted nodes exist: false when a seam graph turned out empty.
bool build(TreeBuilder& builder, TreeKind kind) {
  switch (kind) {
    case TreeKind::kCurve:
      return builder.curve(0) > 0;
    case TreeKind::kTwoCurves:
      return builder.curve(0) > 0 && builder.curve(0) > 0;
    case TreeKind::kUv:
      return builder.uv(0, false) > 0;
    case TreeKind::kUvPatch:
      return builder.uv(0, true) > 0;
    case TreeKind::kUvRootSeam:
      return builder.seam(builder.any_uv(), 0) > 0;
    case TreeKind::kUvSeam:
      return builder.seam(builder.any_uv(), 1) > 0;
    case TreeKind::kCurveOfCurve:
      return builder.sub_curve(builder.curve(0)) > 0;
    case TreeKind::kUvOfUv:
      return builder.uv(builder.any_uv(), builder.coin()) > 0;
    case TreeKind::kCurveOfUv:
      return builder.curve(builder.any_uv()) > 0;
    case TreeKind::kMixed:
      return builder.seam(builder.any_uv(), 1) > 0 && builder.sub_curve(builder.curve(0)) > 0;
    case TreeKind::kPoints:
      return builder.points(0) > 0;
    case TreeKind::kPointsOfUv:
      return builder.points(builder.any_uv()) > 0 && builder.points(0) > 0;
    case TreeKind::kPointsOfCurve:
      return builder.points(builder.points(builder.curve(0))) > 0 && builder.points(0) > 0;
  }
  return false;
}

}  // namespace

Tree random_tree(std::uint64_t seed, TreeKind kind, Surface root, const TreeOptions& options) {
  std::mt19937_64 rng(seed);
  while (true) {
    const std::size_t facets = options.min_facets + pick(rng, options.max_facets - options.min_facets + 1);
    TreeBuilder builder(random_surface(root, facets, rng), rng);
    if (build(builder, kind)) return builder.take();
  }
}

Tree random_tree(std::uint64_t seed, const TreeOptions& options) {
  const auto kind = static_cast<TreeKind>(seed % kNumberOfTreeKinds);
  const auto root = static_cast<Surface>(seed / kNumberOfTreeKinds % kNumberOfSurfaces);
  return random_tree(seed, kind, root, options);
}

}  // namespace multimesh::oracle
