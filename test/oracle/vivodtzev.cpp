// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/vivodtzev.hpp"

#include <algorithm>

namespace multimesh::oracle {

namespace {

constexpr int kOmegaBoundary = kOmega;
constexpr int kOmega0 = kOmega + 1;
constexpr int kOmega1 = kOmega + 2;

bool links_meet_in_link_of_edge(const SimplexSet& K, int a, int b) {
  return intersection(link(K, simplex({a})), link(K, simplex({b}))) == link(K, simplex({a, b}));
}

/// The vertices of the graph at which it is not locally one curve of one kind, and the tagged ones.
/// kinds[i] is the kind of edges[i].
SimplexSet second_order(const SimplexSet& edges, const std::vector<int>& kinds, const SimplexSet& points) {
  SimplexSet special = points;
  for (const Simplex& v : of_dimension(closure(edges), 0)) {
    std::vector<int> around;
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (contains(edges[e], v)) around.push_back(kinds[e]);
    }
    if (around.size() != 2 || around[0] != around[1]) special.push_back(v);
  }
  normalize(special);
  return special;
}

/// Conditions (0) in K and (1) in the graph with its points.
bool allowed(const SimplexSet& K, const SimplexSet& edges, const std::vector<int>& kinds,
             const SimplexSet& points, int a, int b) {
  const SimplexSet B1 = unite(closure(edges), points);
  const SimplexSet B2 = second_order(edges, kinds, points);
  if (!links_meet_in_link_of_edge(with_cone(K, B1, kOmega0), a, b)) return false;
  const SimplexSet G = with_cone(B1, B2, kOmega1);
  return intersection(link(G, simplex({a})), link(G, simplex({b}))).empty();
}

}  // namespace

bool substructure_link_condition(const TaggedSurface& surface, int a, int b, Strata strata) {
  SimplexSet tags = surface.edges;
  SimplexSet points = surface.vertices;
  normalize(tags);
  normalize(points);
  const SimplexSet K = simplices(surface.mesh);
  const SimplexSet rim = boundary(surface.mesh);
  if (strata == Strata::kSeparate) {
    return allowed(with_cone(K, rim, kOmegaBoundary), tags, std::vector<int>(tags.size(), 0), points, a, b);
  }
  const SimplexSet edges = unite(tags, of_dimension(rim, 1));
  std::vector<int> kinds;
  for (const Simplex& e : edges) kinds.push_back((contains(tags, e) ? 1 : 0) + (contains(rim, e) ? 2 : 0));
  return allowed(K, edges, kinds, points, a, b);
}

}  // namespace multimesh::oracle
