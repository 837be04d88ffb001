// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/image.hpp"

#include <algorithm>
#include <stdexcept>

namespace multimesh::oracle {

namespace {

const TreeNode& node_of(const Tree& tree, int node) {
  return tree.nodes.at(static_cast<std::size_t>(node));
}

}  // namespace

std::map<int, int> map_to(const Tree& tree, int node, int ancestor) {
  std::map<int, int> map;
  for (int v : vertices(node_of(tree, node).mesh)) map[v] = v;
  while (node != ancestor) {
    const TreeNode& at = node_of(tree, node);
    if (at.parent < 0) throw std::logic_error("not an ancestor");
    for (auto& [from, to] : map) to = at.image.at(to);
    node = at.parent;
  }
  return map;
}

SimplexSet image(const Tree& tree, int node, int ancestor) {
  const std::map<int, int> map = map_to(tree, node, ancestor);
  SimplexSet facets = facet_set(node_of(tree, node).mesh);
  for (Simplex& f : facets) f = mapped(f, map);
  return closure(facets);
}

SimplexSet preimages(const Complex& mesh, const std::map<int, int>& map, const Simplex& s) {
  SimplexSet over;
  for (const Simplex& t : simplices(mesh, s.n - 1)) {
    if (mapped(t, map) == s) over.push_back(t);
  }
  return over;
}

SimplexSet preimages(const Tree& tree, int node, int ancestor, const Simplex& s) {
  return preimages(node_of(tree, node).mesh, map_to(tree, node, ancestor), s);
}

namespace {

std::string vertex_map_error(const Complex& child, const std::map<int, int>& map) {
  const std::vector<int> all = vertices(child);
  for (int v : all) {
    if (!map.contains(v)) return "vertex " + std::to_string(v) + " has no image";
  }
  for (const auto& [from, to] : map) {
    if (!std::binary_search(all.begin(), all.end(), from)) return std::to_string(from) + " is no vertex";
  }
  return {};
}

}  // namespace

std::string map_error(const Complex& child, const Complex& parent, const std::map<int, int>& map) {
  std::string error = vertex_map_error(child, map);
  if (!error.empty()) return error;
  const SimplexSet targets = child.dim == parent.dim ? facet_set(parent) : simplices(parent, child.dim);
  SimplexSet images;
  for (std::size_t f = 0; f < child.facets.size(); ++f) {
    const Simplex image = mapped(facet_simplex(child, f), map);
    if (image.n != child.dim + 1) return "the image of facet " + std::to_string(f) + " is degenerate";
    if (!contains(targets, image)) return "the image " + to_string(image) + " is no simplex of the parent";
    images.push_back(image);
  }
  std::sort(images.begin(), images.end());
  const auto twice = std::adjacent_find(images.begin(), images.end());
  return twice == images.end() ? "" : "two facets have the image " + to_string(*twice);
}

std::string tree_error(const Tree& tree) {
  if (tree.nodes.empty()) return "no nodes";
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const TreeNode& node = tree.nodes[i];
    const std::string where = "node " + std::to_string(i) + ": ";
    if ((i == 0) != (node.parent < 0)) return where + "exactly the first node is the root";
    if (node.parent >= static_cast<int>(i)) return where + "a parent comes before its children";
    std::string error = manifold_error(node.mesh);
    if (error.empty() && i > 0) error = map_error(node.mesh, node_of(tree, node.parent).mesh, node.image);
    if (!error.empty()) return where + error;
  }
  return {};
}

}  // namespace multimesh::oracle
