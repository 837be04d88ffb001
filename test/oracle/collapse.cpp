// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/collapse.hpp"

#include <algorithm>

#include "oracle/disjoint_sets.hpp"
#include "oracle/image.hpp"

namespace multimesh::oracle {

namespace {

/// dead vertex -> survivor, when the ends of every edge in `edges` are identified.
std::map<int, int> identify(const SimplexSet& edges) {
  std::vector<int> ends;
  for (const Simplex& e : edges) ends.insert(ends.end(), {e.v[0], e.v[1]});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  const auto index = [&](int v) {
    return static_cast<std::size_t>(std::lower_bound(ends.begin(), ends.end(), v) - ends.begin());
  };
  DisjointSets sets(ends.size());
  for (const Simplex& e : edges) sets.join(index(e.v[0]), index(e.v[1]));
  std::map<int, int> merged;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (sets.find(i) != i) merged[ends[i]] = ends[sets.find(i)];
  }
  return merged;
}

int survivor(const std::map<int, int>& merged, int vertex) {
  const auto it = merged.find(vertex);
  return it == merged.end() ? vertex : it->second;
}

Complex identified(const Complex& mesh, const std::map<int, int>& merged) {
  Complex result{mesh.dim, {}};
  for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
    auto facet = mesh.facets[f];
    for (std::size_t i = 0; i <= static_cast<std::size_t>(mesh.dim); ++i)
      facet[i] = survivor(merged, facet[i]);
    result.facets.push_back(facet);
    if (facet_simplex(result, result.facets.size() - 1).n <= mesh.dim) result.facets.pop_back();
  }
  return result;
}

/// The map between the identified meshes, on the vertices that are left.
std::map<int, int> identified_map(const TreeNode& node, const Complex& mesh, const std::map<int, int>& own,
                                  const std::map<int, int>& parents) {
  std::map<int, int> image;
  const std::vector<int> left = vertices(mesh);
  for (const auto& [from, to] : node.image) {
    const int v = survivor(own, from);
    if (std::binary_search(left.begin(), left.end(), v)) image[v] = survivor(parents, to);
  }
  return image;
}

/// The edges of a mesh over the root edge, by its vertex map to the root.
SimplexSet edges_over(const Complex& mesh, const std::map<int, int>& to_root, const Simplex& edge) {
  SimplexSet over;
  for (const auto& f : mesh.facets) {
    for (std::size_t i = 1; i <= static_cast<std::size_t>(mesh.dim); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const Simplex side = simplex({f[i], f[j]});
        if (mapped(side, to_root) == edge) over.push_back(side);
      }
    }
  }
  normalize(over);
  return over;
}

/// The first vertex that is left without a facet: then the contraction is no pure complex any more.
std::string purity_error(const Complex& before, const Complex& after, const std::map<int, int>& merged) {
  const std::vector<int> left = vertices(after);
  for (int v : vertices(before)) {
    if (!merged.contains(v) && !std::binary_search(left.begin(), left.end(), v)) {
      return "vertex " + std::to_string(v) + " is in no facet any more";
    }
  }
  return {};
}

/// What makes the result invalid; empty if nothing.
std::string result_error(const Tree& before, const CollapseResult& result) {
  std::string error = tree_error(result.tree);
  for (std::size_t i = 0; i < before.nodes.size() && error.empty(); ++i) {
    error = purity_error(before.nodes[i].mesh, result.tree.nodes[i].mesh, result.merged[i]);
    if (!error.empty()) error = "node " + std::to_string(i) + ": " + error;
  }
  return error;
}

}  // namespace

CollapseResult collapse(const Tree& tree, int a, int b) {
  CollapseResult result;
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const TreeNode& node = tree.nodes[i];
    TreeNode after{{}, node.parent, {}};
    if (i == 0) {
      result.merged.push_back({{b, a}});
      after.mesh = identified(node.mesh, result.merged[0]);
    } else {
      const std::map<int, int> to_root = map_to(tree, static_cast<int>(i), 0);
      result.merged.push_back(identify(edges_over(node.mesh, to_root, simplex({a, b}))));
      after.mesh = identified(node.mesh, result.merged[i]);
      const auto& parents = result.merged[static_cast<std::size_t>(node.parent)];
      after.image = identified_map(node, after.mesh, result.merged[i], parents);
    }
    result.tree.nodes.push_back(std::move(after));
  }
  result.reason = result_error(tree, result);
  result.valid = result.reason.empty();
  return result;
}

Judgement judge_collapse(const Tree& tree, const TreeSignature& before, int a, int b,
                         const SignatureOptions& options) {
  const CollapseResult result = collapse(tree, a, b);
  if (!result.valid) return {false, false, result.reason};
  const TreeSignature after = image_signature(result.tree, options);
  if (before == after) return {true, true, {}};
  return {true, false, difference(before, after)};
}

}  // namespace multimesh::oracle
