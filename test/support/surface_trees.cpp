// SPDX-License-Identifier: BSD-3-Clause
// The kinds of tree with a surface or curves at the root.
#include <algorithm>
#include <cmath>
#include <random>

#include "multimesh/domains/make_mesh.hpp"
#include "test/support/random_tags.hpp"
#include "test/support/trees.hpp"

namespace multimesh::test {

namespace {

Shape surface(Index size, unsigned seed) {
  const auto side = std::max<Index>(3, static_cast<Index>(std::sqrt(size / 2.0)));
  switch (seed % 4) {
    case 0:
      return grid(side, side);
    case 1:
      return annulus(side + 1, side - 1);
    case 2:
      return torus(std::max<Index>(4, side), std::max<Index>(4, side));
    default:
      return sphere(std::max(1, static_cast<int>(std::lround(std::log2(size / 8.0) / 2))));
  }
}

Shape open_surface(Index size, unsigned seed) {
  return surface(size, seed % 2);
}

std::unique_ptr<Tree> uv_tree(Index size, unsigned seed) {
  auto t = std::make_unique<Tree>(surface(size, seed));
  t->add_cut(NodeId::root, random_seams(t->tree->mesh(NodeId::root), seed));
  return t;
}

std::unique_ptr<Tree> seam_tree(Index size, unsigned seed) {
  auto t = uv_tree(size, seed);
  const NodeId uv{1};
  const Mesh& mesh = t->tree->mesh(uv);
  t->add_tagged(uv, 1, [&](Index e) { return mesh.is_boundary(mesh.dart_of(1, e), 1); });
  return t;
}

std::unique_ptr<Tree> curves_tree(Index size, unsigned seed) {
  auto t = std::make_unique<Tree>(open_surface(size, seed));
  t->add_boundary(NodeId::root);
  t->add_tagged(NodeId::root, 1, random_seams(t->tree->mesh(NodeId::root), seed + 1));
  t->operations->set({.contact = true});
  return t;
}

std::unique_ptr<Tree> deep_tree(Index size, unsigned seed) {
  auto t = uv_tree(size, seed);
  t->add_cut(NodeId{1}, random_seams(t->tree->mesh(NodeId{1}), seed + 1));
  t->add_cut(NodeId{2}, random_seams(t->tree->mesh(NodeId{2}), seed + 2));
  return t;
}

std::unique_ptr<Tree> curve_in_curve_tree(Index size, unsigned seed) {
  auto t = std::make_unique<Tree>(open_surface(size, seed));
  const NodeId rim = t->add_boundary(NodeId::root);
  t->add_tagged(rim, 1, [&](Index e) { return e % 5 != seed % 5; });
  const NodeId curve = t->add_tagged(NodeId::root, 1, random_seams(t->tree->mesh(NodeId::root), seed + 1));
  t->add_tagged(curve, 1, [](Index e) { return e % 3 != 1; });
  return t;
}

void add_points(Tree& t, NodeId parent, unsigned seed) {
  t.add_tagged(parent, 0, random_points(t.tree->mesh(parent), seed));
}

std::unique_ptr<Tree> points_tree(Index size, unsigned seed) {
  auto t = uv_tree(size, seed);
  add_points(*t, NodeId{1}, seed);
  add_points(*t, NodeId::root, seed + 1);
  const NodeId curve = t->add_tagged(NodeId::root, 1, random_seams(t->tree->mesh(NodeId::root), seed + 2));
  const Mesh& mesh = t->tree->mesh(curve);
  bool closed = true;
  for (Index v = 0; v < mesh.capacity(0); ++v)
    closed = closed && !(mesh.is_live(0, v) && mesh.is_boundary(mesh.dart_of(0, v), 0));
  if (!closed) add_points(*t, t->add_boundary(curve), seed + 3);  // some of its ends
  add_points(*t, curve, seed + 4);
  if (seed % 2) t->operations->set({.contact = true});
  return t;
}

/// Chains and loops; some of their edges, and points on both.
std::unique_ptr<Tree> curves_with_points_tree(Index size, unsigned seed) {
  Shape curves{{1, 0, {}}, {}};
  for (Index at = 0, chain = 0; at < size; ++chain) {
    const Index n = 5 + (7 * chain + seed) % 9, first = curves.facets.vertices;
    const bool loop = (chain + seed) % 2;
    for (Index i = 0; i < n; ++i)
      curves.facets.corners.insert(curves.facets.corners.end(),
                                   {first + i, loop && i + 1 == n ? first : first + i + 1});
    curves.facets.vertices += loop ? n : n + 1;
    at += n;
  }
  for (Index v = 0; v < curves.facets.vertices; ++v) curves.points.push_back({double(v), double(v % 7), 0});
  auto t = std::make_unique<Tree>(curves);
  add_points(*t, NodeId::root, seed);
  add_points(*t, t->add_tagged(NodeId::root, 1, [](Index e) { return e % 4 != 3; }), seed + 1);
  return t;
}

std::unique_ptr<Tree> torus_tree(Index size, unsigned) {
  const auto side = std::max<Index>(4, static_cast<Index>(std::sqrt(size / 2.0)));
  auto t = std::make_unique<Tree>(torus(side, side));
  const Tile tile = tile_of_torus(side, side);
  std::vector<Index> facets(tile.over.size());
  for (Index f = 0; f < facets.size(); ++f) facets[f] = f;
  t->add(add_child_by_facets(*t->tree, NodeId::root, tile.grid.facets, tile.over, facets, make_mesh));
  return t;
}

}  // namespace

const std::vector<TreeKind>& surface_tree_kinds() {
  static const std::vector<TreeKind> kinds{{"SurfaceUv", uv_tree},
                                           {"SurfaceUvSeams", seam_tree},
                                           {"SurfaceBoundaryFeatures", curves_tree},
                                           {"UvThreeDeep", deep_tree},
                                           {"CurvesBelowCurves", curve_in_curve_tree},
                                           {"TorusTile", torus_tree},
                                           {"SurfacePoints", points_tree}};
  return kinds;
}

const std::vector<TreeKind>& curve_tree_kinds() {
  static const std::vector<TreeKind> kinds{{"CurvesPoints", curves_with_points_tree}};
  return kinds;
}

}  // namespace multimesh::test
