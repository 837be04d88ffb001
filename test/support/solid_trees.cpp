// SPDX-License-Identifier: BSD-3-Clause
// The kinds of tree with a tetrahedral mesh at the root.
#include <algorithm>
#include <cmath>

#include "multimesh/domains/make_mesh.hpp"
#include "test/support/random_tags.hpp"
#include "test/support/solids.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {

namespace {

/// About `size` tetrahedra, at least 24: a box, a ball, a solid torus, a shell.
Shape solid(Index size, unsigned seed) {
  const auto side = std::max<Index>(1, static_cast<Index>(std::lround(std::cbrt(size / 6.0))));
  switch (seed % 4) {
    case 0:
      return box(std::max<Index>(2, side), side, std::max<Index>(2, side));
    case 1:
      return size < 60 ? cone(sphere(1)) : layers(grid(side, side), std::max<Index>(1, side));
    case 2:
      return layers(annulus(side + 3, side), side);
    default:
      return layers(sphere(size < 100 ? 0 : 1), std::max<Index>(1, size / 100));
  }
}

std::function<bool(Index)> in(std::vector<bool> tags) {
  return [tags = std::move(tags)](Index s) { return s < tags.size() && tags[s]; };
}

bool is_empty(const std::vector<bool>& tags) {
  return std::find(tags.begin(), tags.end(), true) == tags.end();
}

/// A tree over a solid, and a surface of so many tetrahedra in it.
struct Maker {
  Maker(Index size, unsigned seed)
      : t(std::make_unique<Tree>(solid(size, seed))), random(seed), lump(std::max<Index>(2, size / 4)) {}
  const Mesh& root() const { return t->tree->mesh(NodeId::root); }

  std::vector<bool> frontier(bool with_boundary) {
    std::vector<bool> tags;
    do tags = random_frontier(root(), 1 + random() % lump, with_boundary, random);
    while (is_empty(tags));
    return tags;
  }
  NodeId surface(bool with_boundary) { return t->add_tagged(NodeId::root, 2, in(frontier(with_boundary))); }
  /// A path on a mesh.
  NodeId curve(NodeId n) {
    return t->add_tagged(n, 1, random_seams(t->tree->mesh(n), static_cast<unsigned>(random() % 1000)));
  }
  NodeId points(NodeId n) {
    return t->add_tagged(n, 0, random_points(t->tree->mesh(n), static_cast<unsigned>(random() % 1000)));
  }
  bool is_closed(NodeId surface) const {
    const Mesh& mesh = t->tree->mesh(surface);
    for (Index e = 0; e < mesh.capacity(1); ++e)
      if (mesh.is_live(1, e) && mesh.is_boundary(mesh.dart_of(1, e), 1)) return false;
    return true;
  }

  std::unique_ptr<Tree> t;
  std::mt19937 random;
  Index lump;
};

std::unique_ptr<Tree> boundary_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  m.t->add_boundary(NodeId::root);
  return std::move(m.t);
}

std::unique_ptr<Tree> closed_surface_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  m.surface(true);
  return std::move(m.t);
}

std::unique_ptr<Tree> open_surface_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  auto tags = m.frontier(true);
  // Without two triangles, so that it is not closed.
  for (int i = 0; i < 2; ++i) {
    const auto one = std::find(tags.begin(), tags.end(), true);
    if (std::count(one, tags.end(), true) > 1) *one = false;
  }
  const NodeId surface = m.t->add_tagged(NodeId::root, 2, in(tags));
  m.t->add_boundary(surface);
  return std::move(m.t);
}

/// Two surfaces, and the curves that their union is not a surface at.
std::unique_ptr<Tree> two_surfaces_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  const auto one = m.frontier(seed % 2), two = m.frontier(seed % 3 == 0);
  m.t->add_tagged(NodeId::root, 2, in(one));
  m.t->add_tagged(NodeId::root, 2, in(two));
  const Mesh& root = m.root();
  std::vector<int> around(root.capacity(1), 0);
  for (Index f = 0; f < root.capacity(2); ++f) {
    if (!one[f] && !two[f]) continue;
    const Dart d = root.dart_of(2, f);
    for (const Permutation p : {Permutation{}, edge_ax, edge_bx})
      ++around[root.simplex(root.reorder(d, p), 1)];
  }
  std::vector<bool> curve(root.capacity(1), false);
  for (Index e = 0; e < curve.size(); ++e) curve[e] = around[e] != 0 && around[e] != 2;
  if (!is_empty(curve)) m.t->add_tagged(NodeId::root, 1, in(curve));
  m.t->operations->set({.contact = true});
  return std::move(m.t);
}

std::unique_ptr<Tree> feature_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  const NodeId rim = m.t->add_boundary(NodeId::root);
  m.curve(rim);
  m.curve(NodeId::root);
  if (seed % 2) m.t->operations->set({.contact = true});
  return std::move(m.t);
}

std::unique_ptr<Tree> non_manifold_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  std::vector<bool> faces(m.root().capacity(2)), edges(m.root().capacity(1));
  for (auto&& tag : faces) tag = m.random() % 6 == 0;
  for (auto&& tag : edges) tag = m.random() % 10 == 0;
  const Mesh& root = m.root();
  for (Index f = 0; f < faces.size(); ++f) faces[f] = faces[f] && root.is_live(2, f);
  for (Index e = 0; e < edges.size(); ++e) edges[e] = edges[e] && root.is_live(1, e);
  if (is_empty(faces)) return non_manifold_tree(size, seed + 100);
  const NodeId surface = m.t->add_tagged(NodeId::root, 2, in(faces));
  if (!is_empty(edges)) m.t->add_tagged(NodeId::root, 1, in(edges));
  if (!m.is_closed(surface)) m.t->add_boundary(surface);
  return std::move(m.t);
}

/// root <- part <- its boundary <- a path on that
std::unique_ptr<Tree> part_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  const NodeId part = m.t->add_tagged(NodeId::root, 3, in(random_lump(m.root(), size / 2, m.random)));
  const NodeId rim = m.t->add_boundary(part);
  m.curve(rim);
  return std::move(m.t);
}

/// root <- all of it, cut open <- a part of that, cut further; a curve below each.
std::unique_ptr<Tree> cut_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  const NodeId all = m.t->add_cut(NodeId::root, in(m.frontier(false)));
  const Mesh& mesh = m.t->tree->mesh(all);
  m.curve(all);
  m.t->add_tagged(all, 3, in(random_lump(mesh, size / 2, m.random)));
  if (seed % 2) m.surface(false);
  return std::move(m.t);
}

/// Points below all that can be below tetrahedra.
std::unique_ptr<Tree> points_tree(Index size, unsigned seed) {
  Maker m(size, seed);
  m.points(NodeId::root);
  m.points(m.t->add_tagged(NodeId::root, 3, in(random_lump(m.root(), size / 2, m.random))));
  const NodeId surface = m.surface(seed % 2);
  m.points(surface);
  const NodeId curve = m.curve(surface);
  m.points(curve);
  if (seed % 3 == 0) m.t->operations->set({.contact = true});
  return std::move(m.t);
}

/// The smallest 3-torus that can be worked on has 384 tetrahedra, whatever the size asked for.
std::unique_ptr<Tree> torus3_tree(Index, unsigned) {
  auto t = std::make_unique<Tree>(torus3(4));
  const Tile tile = tile_of_torus3(4);
  std::vector<Index> facets(tile.over.size());
  for (Index f = 0; f < facets.size(); ++f) facets[f] = f;
  const NodeId cube =
      t->add(add_child_by_facets(*t->tree, NodeId::root, tile.grid.facets, tile.over, facets, make_mesh));
  t->add_boundary(cube);
  return t;
}

}  // namespace

const std::vector<TreeKind>& solid_tree_kinds() {
  static const std::vector<TreeKind> kinds{{"SolidBoundary", boundary_tree},
                                           {"SolidClosedSurface", closed_surface_tree},
                                           {"SolidOpenSurface", open_surface_tree},
                                           {"SolidTwoSurfaces", two_surfaces_tree},
                                           {"SolidFeatures", feature_tree},
                                           {"SolidNonManifold", non_manifold_tree},
                                           {"SolidPart", part_tree},
                                           {"SolidCut", cut_tree},
                                           {"Torus3Tile", torus3_tree},
                                           {"SolidPoints", points_tree}};
  return kinds;
}

}  // namespace multimesh::test
