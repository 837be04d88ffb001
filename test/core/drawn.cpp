// SPDX-License-Identifier: BSD-3-Clause
#include "test/core/drawn.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "multimesh/domains/make_mesh.hpp"

namespace multimesh::test {

namespace {

template <class Facets>
FacetList list_of(int dimension, const Facets& facets) {
  FacetList list{dimension, 0, {}};
  for (const auto& f : facets) list.corners.insert(list.corners.end(), f.begin(), f.end());
  list.vertices = *std::max_element(list.corners.begin(), list.corners.end()) + 1;
  return list;
}

Shape shape(FacetList facets) {
  Shape s{std::move(facets), {}};
  for (Index v = 0; v < s.facets.vertices; ++v)
    s.points.push_back({double(v), double(v * v % 7), double(v % 3)});
  return s;
}

}  // namespace

FacetList triangles(std::initializer_list<Triangle> list) {
  return list_of(2, list);
}
FacetList segments(std::initializer_list<Segment> list) {
  return list_of(1, list);
}

Tree drawn(std::initializer_list<Triangle> root) {
  return Tree(shape(triangles(root)));
}

NodeId add_drawn(Tree& tree, NodeId parent, const FacetList& child, std::initializer_list<Index> image) {
  const std::vector<Index> to(image);
  FacetList over{child.dimension, 0, {}};
  for (const Index v : child.corners) over.corners.push_back(to.at(v));
  const Mesh& above = tree.tree->mesh(parent);
  std::vector<Index> facets;
  for (std::size_t f = 0; f < over.size(); ++f) {
    const Dart d = find_dart(above, over.facet(f));
    if (d == no_dart)
      throw std::logic_error("facet " + std::to_string(f) + " of the drawn child lies nowhere");
    facets.push_back(above.facet(d));
  }
  return tree.add(add_child_by_facets(*tree.tree, parent, child, over, facets, make_mesh));
}

std::vector<std::vector<Index>> sorted_facets(const Mesh& mesh) {
  std::vector<std::vector<Index>> all;
  for (const Dart f : simplices_of(mesh, mesh.dimension())) {
    std::vector<Index> v(4);
    mesh.vertices(f, v.data());
    v.resize(static_cast<std::size_t>(mesh.dimension()) + 1);
    std::sort(v.begin(), v.end());
    all.push_back(v);
  }
  std::sort(all.begin(), all.end());
  return all;
}

Dart edge(const Tree& tree, NodeId n, Index a, Index b) {
  const Dart d = find_dart(tree.tree->mesh(n), {a, b});
  if (d == no_dart) ADD_FAILURE() << "no edge " << a << "-" << b << " in mesh " << index(n);
  return d;
}

Tree two_neighbors() {
  return drawn({{0, 1, 2}, {3, 1, 0}, {0, 2, 4}});
}

NodeId add_cut_on_edge01(Tree& tree, NodeId parent) {
  return add_drawn(tree, parent, triangles({{0, 1, 2}, {6, 3, 5}, {0, 2, 4}}), {0, 1, 2, 1, 4, 0, 3});
}

Tree two_neighbors_plus_one() {
  return drawn({{0, 1, 2}, {3, 1, 0}, {0, 2, 4}, {3, 0, 4}});
}

Tree disk_to_individual(Index n) {
  FacetList fan{2, n + 1, {}}, single{2, 3 * n, {}};
  std::vector<Index> facets;
  for (Index i = 0; i < n; ++i) {
    fan.corners.insert(fan.corners.end(), {0, i + 1, (i + 1) % n + 1});
    single.corners.insert(single.corners.end(), {3 * i, 3 * i + 1, 3 * i + 2});
    facets.push_back(i);
  }
  Tree tree(shape(fan));
  tree.add(add_child_by_facets(*tree.tree, NodeId::root, single, fan, facets, make_mesh));
  return tree;
}

}  // namespace multimesh::test
