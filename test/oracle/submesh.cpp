// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/submesh.hpp"

#include <algorithm>
#include <utility>

#include "oracle/disjoint_sets.hpp"
#include "oracle/gluing.hpp"
#include "oracle/image.hpp"

namespace multimesh::oracle {

TreeNode surface_child(const Complex& parent, int parent_index, const std::vector<std::size_t>& facets,
                       const SimplexSet& cuts) {
  Complex part{2, {}};
  for (std::size_t f : facets) part.facets.push_back(parent.facets[f]);
  const Gluing glued = glue(part, cuts);
  TreeNode node{{2, glued.corner}, parent_index, {}};
  for (const auto& [vertex, copy] : vertex_copies(glued)) node.image[copy] = vertex;
  return node;
}

namespace {

/// Gives out child vertices: one per vertex of the parent, or one per end of an edge where it is cut.
class CurveVertices {
 public:
  CurveVertices(const SimplexSet& edges, std::vector<int> cut_at) : cut_at_(std::move(cut_at)) {
    std::map<int, int> degree;
    for (const Simplex& e : edges) {
      ++degree[e.v[0]];
      ++degree[e.v[1]];
    }
    for (const auto& [v, n] : degree) {
      if (n != 2) cut_at_.push_back(v);
    }
    std::sort(cut_at_.begin(), cut_at_.end());
  }

  int vertex(int of_parent) {
    const bool cut = std::binary_search(cut_at_.begin(), cut_at_.end(), of_parent);
    if (!cut && known_.contains(of_parent)) return known_[of_parent];
    const int fresh = static_cast<int>(image.size());
    known_[of_parent] = fresh;
    image[fresh] = of_parent;
    return fresh;
  }

  std::map<int, int> image;

 private:
  std::vector<int> cut_at_;
  std::map<int, int> known_;
};

}  // namespace

TreeNode curve_child(const Complex& parent, int parent_index, const SimplexSet& edges,
                     const std::vector<int>& cut_at) {
  const SimplexSet existing = simplices(parent, 1);
  CurveVertices ids(edges, cut_at);
  TreeNode node{{1, {}}, parent_index, {}};
  for (const Simplex& e : edges) {
    if (!contains(existing, e)) continue;
    const int from = ids.vertex(e.v[0]);
    node.mesh.facets.push_back({from, ids.vertex(e.v[1]), -1});
  }
  node.image = ids.image;
  return node;
}

TreeNode point_child(int parent_index, const std::vector<int>& over) {
  TreeNode node{{0, {}}, parent_index, {}};
  for (const int v : over) {
    const auto point = static_cast<int>(node.mesh.facets.size());
    node.mesh.facets.push_back({point, -1, -1, -1});
    node.image[point] = v;
  }
  return node;
}

TreeNode cut_child(int parent_index, const SimplexSet& over, const SimplexSet& cuts) {
  const int corners = over.at(0).n;
  const auto corner = [&](std::size_t facet, int vertex) {
    int i = 0;
    while (over[facet].v[static_cast<std::size_t>(i)] != vertex) ++i;
    return facet * static_cast<std::size_t>(corners) + static_cast<std::size_t>(i);
  };
  std::map<Simplex, std::vector<std::size_t>> sides;
  for (std::size_t f = 0; f < over.size(); ++f)
    for (int i = 0; i < corners; ++i)
      sides[minus(over[f], simplex({over[f].v[static_cast<std::size_t>(i)]}))].push_back(f);
  DisjointSets sets(over.size() * static_cast<std::size_t>(corners));
  for (const auto& [side, uses] : sides) {
    if (uses.size() != 2 || contains(cuts, side)) continue;
    for (int i = 0; i < side.n; ++i) {
      const int v = side.v[static_cast<std::size_t>(i)];
      sets.join(corner(uses[0], v), corner(uses[1], v));
    }
  }
  TreeNode node{{corners - 1, {}}, parent_index, {}};
  for (std::size_t f = 0; f < over.size(); ++f) {
    Facet facet{-1, -1, -1, -1};
    for (int i = 0; i < corners; ++i) {
      const int v = over[f].v[static_cast<std::size_t>(i)];
      const int copy = static_cast<int>(sets.find(corner(f, v)));
      facet[static_cast<std::size_t>(i)] = copy;
      node.image[copy] = v;
    }
    node.mesh.facets.push_back(facet);
  }
  return node;
}

namespace {

using Count = std::map<Simplex, int>;

/// How many simplices of a node lie over each simplex of an ancestor.
Count preimage_counts(const Tree& tree, int node, int host) {
  Count count;
  const std::map<int, int> map = map_to(tree, node, host);
  for (const Simplex& s : simplices(tree.nodes[static_cast<std::size_t>(node)].mesh)) ++count[mapped(s, map)];
  return count;
}

bool is_cut(const Complex& host, const EdgeUse& use, const Count& count) {
  if (use.count != 2) return false;
  const bool one = count.contains(facet_simplex(host, static_cast<std::size_t>(use.facet[0])));
  const bool two = count.contains(facet_simplex(host, static_cast<std::size_t>(use.facet[1])));
  return one != two || (one && count.at(use.edge) != 1);
}

/// Whether the vertex is not inside one curve of one kind.
bool is_corner(int vertex, const SimplexSet& edges, const SimplexSet& rim, const Count& count) {
  const Simplex point = simplex({vertex});
  std::vector<int> around;
  for (const Simplex& e : edges) {
    if (contains(e, vertex)) around.push_back(count.at(e));
  }
  return around.size() != 2 || around[0] != around[1] || around[0] != count.at(point) || contains(rim, point);
}

}  // namespace

SeamGraph seam_graph(const Tree& tree, int node, int host) {
  const Complex& surface = tree.nodes[static_cast<std::size_t>(host)].mesh;
  const Count count = preimage_counts(tree, node, host);
  SeamGraph graph;
  for (const EdgeUse& use : edge_uses(surface)) {
    if (is_cut(surface, use, count)) graph.edges.push_back(use.edge);
  }
  const SimplexSet rim = boundary(surface);
  for (const Simplex& v : of_dimension(closure(graph.edges), 0)) {
    if (is_corner(v.v[0], graph.edges, rim, count)) graph.corners.push_back(v.v[0]);
  }
  return graph;
}

SimplexSet edges_over(const Tree& tree, int node, int host, const SimplexSet& edges) {
  const std::map<int, int> map = map_to(tree, node, host);
  SimplexSet over;
  for (const Simplex& e : simplices(tree.nodes[static_cast<std::size_t>(node)].mesh, 1)) {
    if (contains(edges, mapped(e, map))) over.push_back(e);
  }
  return over;
}

std::vector<int> vertices_over(const Tree& tree, int node, int host, const std::vector<int>& points) {
  std::vector<int> over;
  for (const auto& [from, to] : map_to(tree, node, host)) {
    if (std::find(points.begin(), points.end(), to) != points.end()) over.push_back(from);
  }
  return over;
}

}  // namespace multimesh::oracle
