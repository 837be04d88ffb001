// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/split.hpp"

#include <algorithm>

#include "oracle/image.hpp"

namespace multimesh::oracle {

namespace {

/// The facet with vertex `from` replaced by `to`.
Facet replaced(Facet facet, int dim, int from, int to) {
  std::replace(facet.begin(), facet.begin() + dim + 1, from, to);
  return facet;
}

/// Splits the facets on one edge. No two edges over one edge are in one facet, so one at a time is enough.
Complex split_edge(const Complex& mesh, const Simplex& edge, int vertex) {
  Complex result{mesh.dim, {}};
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    if (contains(facet_simplex(mesh, f), edge)) {
      result.facets.push_back(replaced(mesh.facets[f], mesh.dim, edge.v[0], vertex));
      result.facets.push_back(replaced(mesh.facets[f], mesh.dim, edge.v[1], vertex));
    } else {
      result.facets.push_back(mesh.facets[f]);
    }
  }
  return result;
}

}  // namespace

SplitResult split(const Tree& tree, int a, int b) {
  SplitResult result;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    TreeNode node = tree.nodes[i];
    std::map<Simplex, int> fresh;
    int next = vertices(node.mesh).back();
    for (const Simplex& e : preimages(tree, static_cast<int>(i), 0, simplex({a, b}))) {
      fresh[e] = ++next;
      node.mesh = split_edge(node.mesh, e, next);
      if (i == 0) continue;
      node.image[next] =
          result.vertex[static_cast<std::size_t>(node.parent)].at(mapped(e, tree.nodes[i].image));
    }
    result.tree.nodes.push_back(std::move(node));
    result.vertex.push_back(std::move(fresh));
  }
  return result;
}

}  // namespace multimesh::oracle
