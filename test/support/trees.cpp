// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/trees.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "adapters/openmesh/connectivity.hpp"
#include "adapters/openmesh/make_mesh.hpp"

namespace multimesh::test {

namespace {

constexpr const char* point_name = "test:point";

OpenMesh::PolyConnectivity& openmesh_of(Mesh& mesh) {
  return dynamic_cast<openmesh::Connectivity&>(mesh).openmesh();
}

}  // namespace

Tree::Tree(const Shape& root) {
  tree = std::make_unique<MultiMesh>(openmesh::make_mesh(root.facets));
  operations = std::make_unique<Propagation>(*tree);
  add(NodeId::root);
  for (Index v = 0; v < root.points.size(); ++v)
    (*points_[0])[v] = Point3(root.points[v][0], root.points[v][1], root.points[v][2]);
}

NodeId Tree::add(NodeId id) {
  auto& om = openmesh_of(tree->mesh(id));
  OpenMesh::VPropHandleT<Point3> property;
  om.add_property(property, point_name);
  auto& values = om.property(property).data_vector();
  points_.push_back(&values);
  attributes_.push_back(std::make_unique<VertexAttribute<Point3>>(id, values));
  operations->add(*attributes_.back());
  if (id == NodeId::root) return id;
  const Mesh& mesh = tree->mesh(id);
  for (Index v = 0; v < mesh.capacity(0); ++v)
    if (mesh.dart_of(0, v) != no_dart)
      values[v] =
          points(NodeId::root)[tree->mesh(NodeId::root).vertex(tree->to_root(id, mesh.dart_of(0, v)))];
  return id;
}

NodeId Tree::add_cut(NodeId parent, const std::function<bool(Index)>& seam) {
  // Corners are joined across all interior edges that are no seam.
  const Mesh& mesh = tree->mesh(parent);
  const Index facets = mesh.capacity(2);
  FacetList over{2, mesh.capacity(0), {}};
  std::vector<Index> parent_facets;
  std::vector<Index> corner_at(4 * mesh.capacity(1) * 2, no_index);  // by dart code
  for (Index f = 0; f < facets; ++f) {
    const Dart d = mesh.dart_of(2, f);
    Index v[4];
    mesh.vertices(d, v);
    for (int i = 0; i < 3; ++i) {
      const Dart at = mesh.reorder(d, permutation(i, (i + 1) % 3, (i + 2) % 3));
      corner_at[code(at)] = corner_at[code(mesh.switch_dart(at, 1))] =
          static_cast<Index>(over.corners.size());
      over.corners.push_back(v[i]);
    }
    parent_facets.push_back(f);
  }
  std::vector<Index> cls(over.corners.size());
  for (Index c = 0; c < cls.size(); ++c) cls[c] = c;
  const std::function<Index(Index)> find = [&](Index c) { return cls[c] == c ? c : cls[c] = find(cls[c]); };
  for (Index e = 0; e < mesh.capacity(1); ++e) {
    const Dart d = mesh.dart_of(1, e);
    if (mesh.is_boundary(d, 1) || seam(e)) continue;
    for (const Dart at : {d, mesh.switch_dart(d, 0)})
      cls[find(corner_at[code(at)])] = find(corner_at[code(mesh.switch_dart(at, 2))]);
  }
  FacetList child{2, 0, {}};
  std::vector<Index> number(cls.size(), no_index);
  for (Index c = 0; c < cls.size(); ++c) {
    Index& id = number[find(c)];
    if (id == no_index) id = child.vertices++;
    child.corners.push_back(id);
  }
  return add(add_child_by_facets(*tree, parent, child, over, parent_facets, openmesh::make_mesh));
}

NodeId Tree::add_tagged(NodeId parent, int k, const std::function<bool(Index)>& tagged,
                        const CutOptions& options) {
  return add(add_child_from_tags(*tree, parent, k, tagged, openmesh::make_mesh, options));
}

NodeId Tree::add_boundary(NodeId parent) {
  return add(add_child_from_boundary(*tree, parent, openmesh::make_mesh));
}

namespace {

/// A random simple path of edges in the parent, closed or open, as tags: a walk that does not visit a
/// vertex twice.
std::vector<bool> random_path(const Mesh& mesh, std::size_t length, std::mt19937& random) {
  std::vector<bool> tagged(mesh.capacity(1), false), visited(mesh.capacity(0), false);
  Dart at = mesh.dart_of(0, static_cast<Index>(random() % mesh.capacity(0)));
  visited[mesh.vertex(at)] = true;
  DartBuffer star;
  for (std::size_t i = 0; i < length; ++i) {
    mesh.star(at, 0, star);
    bool moved = false;
    for (int tries = 0; tries < 8 && !moved; ++tries) {
      const Dart edge = star[random() % star.size()], there = mesh.switch_dart(edge, 0);
      if (visited[mesh.vertex(there)]) continue;
      visited[mesh.vertex(there)] = true;
      tagged[mesh.simplex(edge, 1)] = moved = true;
      at = there;
    }
    if (!moved) break;
  }
  return tagged;
}

std::function<bool(Index)> random_seams(const Mesh& mesh, unsigned seed) {
  std::mt19937 random(seed);
  auto seam = random_path(mesh, 3 + mesh.capacity(1) / 12, random);
  const auto second = random_path(mesh, 2 + mesh.capacity(1) / 20, random);
  for (std::size_t e = 0; e < seam.size(); ++e) seam[e] = seam[e] || second[e];
  return [seam](Index e) { return e < seam.size() && seam[e]; };
}

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

std::unique_ptr<Tree> torus_tree(Index size, unsigned) {
  const auto side = std::max<Index>(4, static_cast<Index>(std::sqrt(size / 2.0)));
  auto t = std::make_unique<Tree>(torus(side, side));
  const Tile tile = tile_of_torus(side, side);
  std::vector<Index> facets(tile.over.size());
  for (Index f = 0; f < facets.size(); ++f) facets[f] = f;
  t->add(
      add_child_by_facets(*t->tree, NodeId::root, tile.grid.facets, tile.over, facets, openmesh::make_mesh));
  return t;
}

}  // namespace

const std::vector<TreeKind>& tree_kinds() {
  static const std::vector<TreeKind> kinds{{"SurfaceUv", uv_tree},
                                           {"SurfaceUvSeams", seam_tree},
                                           {"SurfaceBoundaryFeatures", curves_tree},
                                           {"UvThreeDeep", deep_tree},
                                           {"CurvesBelowCurves", curve_in_curve_tree},
                                           {"TorusTile", torus_tree}};
  return kinds;
}

}  // namespace multimesh::test
