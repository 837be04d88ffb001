// SPDX-License-Identifier: BSD-3-Clause
#include "test/core/bridge.hpp"

#include <algorithm>
#include <stdexcept>

#include "multimesh/domains/make_mesh.hpp"
#include "oracle/random_solid_trees.hpp"

namespace multimesh::test {

namespace {

std::size_t corners(int dimension) {
  return static_cast<std::size_t>(dimension) + 1;
}

}  // namespace

oracle::Complex complex_of(const Mesh& mesh) {
  const int d = mesh.dimension();
  oracle::Complex c{d, {}};
  for (const Dart f : simplices_of(mesh, d)) {
    Index v[4] = {};
    mesh.vertices(f, v);
    oracle::Facet facet{};
    for (std::size_t i = 0; i < corners(d); ++i) facet[i] = static_cast<int>(v[i]);
    c.facets.push_back(facet);
  }
  return c;
}

oracle::Tree oracle_tree(const MultiMesh& tree) {
  oracle::Tree plain_tree;
  const auto nodes = tree.nodes();
  for (const NodeId n : nodes) {
    oracle::TreeNode node{complex_of(tree.mesh(n)), -1, {}};
    if (n != NodeId::root) {
      const NodeId above = tree.parent(n);
      node.parent = static_cast<int>(std::find(nodes.begin(), nodes.end(), above) - nodes.begin());
      for (const Dart d : all_darts(tree.mesh(n)))
        node.image[static_cast<int>(tree.mesh(n).vertex(d))] =
            static_cast<int>(tree.mesh(above).vertex(tree.to_parent(n, d)));
    }
    plain_tree.nodes.push_back(std::move(node));
  }
  return plain_tree;
}

std::optional<FacetList> oriented(const oracle::Complex& complex) {
  FacetList list{complex.dim, 0, {}};
  for (const auto& f : complex.facets)
    for (std::size_t i = 0; i < corners(complex.dim); ++i) list.corners.push_back(static_cast<Index>(f[i]));
  list.vertices = *std::max_element(list.corners.begin(), list.corners.end()) + 1;
  Cut pieces = cut(list);
  if (pieces.facets.vertices != oracle::vertices(complex).size()) return std::nullopt;
  for (Index& v : pieces.facets.corners) v = pieces.source[v];
  pieces.facets.vertices = list.vertices;
  return pieces.facets;
}

std::unique_ptr<Tree> tree_from(const oracle::Tree& tree) {
  std::vector<FacetList> lists;
  for (const oracle::TreeNode& n : tree.nodes) {
    auto list = oriented(n.mesh);
    if (!list) return nullptr;
    lists.push_back(std::move(*list));
  }
  Shape root{lists[0], {}};
  for (Index v = 0; v < lists[0].vertices; ++v)
    root.points.push_back({double(v), double(v * v % 17), double(v * v * v % 13)});
  auto result = std::make_unique<Tree>(root);
  for (std::size_t n = 1; n < tree.nodes.size(); ++n) {
    const NodeId above{static_cast<std::uint32_t>(tree.nodes[n].parent)};
    auto mesh = make_mesh(lists[n]);
    std::vector<Anchor> anchors;
    for (Index f = 0; f < lists[n].size(); ++f) {
      const auto v = lists[n].facet(f);
      std::vector<Index> image;
      for (const Index vertex : v)
        image.push_back(static_cast<Index>(tree.nodes[n].image.at(static_cast<int>(vertex))));
      anchors.push_back({dart_with(*mesh, f, v.data()), find_dart(result->tree->mesh(above), image)});
    }
    result->add(result->tree->add_child(above, std::move(mesh), anchors));
  }
  return result;
}

Dart find_dart(const Mesh& mesh, std::span<const Index> vertices) {
  Index v[4] = {};
  for (const Dart d : all_darts(mesh)) {
    mesh.vertices(d, v);
    if (std::equal(vertices.begin(), vertices.end(), v)) return d;
  }
  return no_dart;
}

DartBuffer simplices_of(const Mesh& mesh, int k) {
  DartBuffer all;
  for (Index s = 0; s < mesh.capacity(k); ++s)
    if (mesh.is_live(k, s) && mesh.dart_of(k, s) != no_dart) all.push_back(mesh.dart_of(k, s));
  return all;
}

DartBuffer all_darts(const Mesh& mesh) {
  DartBuffer all;
  for (const Dart f : simplices_of(mesh, mesh.dimension()))
    for (std::uint8_t p = 0; p < number_of_orders(mesh.dimension()); ++p) all.push_back(mesh.reorder(f, {p}));
  return all;
}

std::vector<EdgeCopy> edge_copies(const MultiMesh& tree, Dart root_edge) {
  Copies copies;
  copies.collect(tree, root_edge, 1);
  const auto nodes = tree.nodes();
  std::vector<EdgeCopy> list;
  for (const Copy& c : copies.all()) {
    Index v[4] = {};
    tree.mesh(c.node).vertices(c.dart, v);
    list.push_back({static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), c.node) - nodes.begin()),
                    static_cast<int>(v[0]), static_cast<int>(v[1])});
  }
  return list;
}

PlainTree plain(const oracle::Tree& tree, const std::vector<std::map<int, int>>& renamed) {
  PlainTree result;
  const auto name = [&](std::size_t n, int v) {
    if (renamed.empty()) return v;
    const auto it = renamed[n].find(v);
    return it == renamed[n].end() ? v : it->second;
  };
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    oracle::SimplexSet facets;
    for (std::size_t f = 0; f < tree.nodes[n].mesh.facets.size(); ++f) {
      oracle::Simplex s;
      for (std::size_t i = 0; i < corners(tree.nodes[n].mesh.dim); ++i)
        s = oracle::joined(s, name(n, tree.nodes[n].mesh.facets[f][i]));
      facets.push_back(s);
    }
    std::sort(facets.begin(), facets.end());
    result.facets.push_back(std::move(facets));
    std::map<int, int> image;
    for (const auto& [from, to] : tree.nodes[n].image)
      image[name(n, from)] = name(static_cast<std::size_t>(tree.nodes[n].parent), to);
    result.images.push_back(std::move(image));
  }
  return result;
}

std::unique_ptr<Tree> random_small_tree(std::uint64_t seed, std::size_t most_facets) {
  for (std::uint64_t s = 1000 * seed; s < 1000 * (seed + 1); ++s)
    if (auto tree = tree_from(oracle::random_tree(s, {.min_facets = 4, .max_facets = most_facets})))
      return tree;
  throw std::logic_error("no orientable tree");
}

std::unique_ptr<Tree> random_small_solid_tree(std::uint64_t seed, std::size_t most_facets) {
  const auto kind = static_cast<oracle::SolidTreeKind>(seed % oracle::kNumberOfSolidTreeKinds);
  const auto solid = static_cast<oracle::Solid>(seed / oracle::kNumberOfSolidTreeKinds % 4);
  return tree_from(
      oracle::random_solid_tree(seed, kind, solid, {.min_facets = 4, .max_facets = most_facets}));
}

}  // namespace multimesh::test
