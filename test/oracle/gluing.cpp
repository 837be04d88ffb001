// SPDX-License-Identifier: BSD-3-Clause
#include "oracle/gluing.hpp"

#include <algorithm>

#include "oracle/disjoint_sets.hpp"

namespace multimesh::oracle {

namespace {

struct Side {
  Simplex edge;
  int facet;
  int corner;
};

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

int corner_of(const Facet& facet, int vertex) {
  return static_cast<int>(std::find(facet.begin(), facet.begin() + 3, vertex) - facet.begin());
}

/// Joins the corners of the two facets at both ends of the glued edge.
void join_corners(const Gluing& g, const EdgeUse& use, DisjointSets& sets) {
  for (std::size_t end = 0; end < 2; ++end) {
    const int v = use.edge.v[end];
    const int i = corner_of(g.facets[at(use.facet[0])], v);
    const int j = corner_of(g.facets[at(use.facet[1])], v);
    sets.join(at(3 * use.facet[0] + i), at(3 * use.facet[1] + j));
  }
}

void number_corners(Gluing& g, const DisjointSets& sets) {
  std::vector<int> number(3 * g.facets.size(), -1);
  g.corner.resize(g.facets.size());
  for (std::size_t k = 0; k < number.size(); ++k) {
    const std::size_t root = sets.find(k);  // the smallest of its class, hence numbered before k
    if (root == k) number[k] = g.corners++;
    g.corner[k / 3][k % 3] = number[root];
  }
}

}  // namespace

std::vector<EdgeUse> edge_uses(const Complex& c) {
  std::vector<Side> sides;
  sides.reserve(3 * c.facets.size());
  for (std::size_t f = 0; f < c.facets.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Simplex edge = simplex({c.facets[f][(i + 1) % 3], c.facets[f][(i + 2) % 3]});
      sides.push_back({edge, static_cast<int>(f), static_cast<int>(i)});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
    return s.edge != t.edge ? s.edge < t.edge : s.facet < t.facet;
  });
  std::vector<EdgeUse> uses;
  uses.reserve(sides.size());
  for (const Side& s : sides) {
    if (uses.empty() || uses.back().edge != s.edge) uses.push_back({.edge = s.edge});
    EdgeUse& use = uses.back();
    if (use.count < 2) {
      use.facet[at(use.count)] = s.facet;
      use.corner[at(use.count)] = s.corner;
    }
    ++use.count;
  }
  return uses;
}

Gluing glue(const Complex& c, const SimplexSet& cuts) {
  return glue(c, edge_uses(c), cuts);
}

Gluing glue(const Complex& c, const std::vector<EdgeUse>& uses, const SimplexSet& cuts) {
  Gluing g;
  g.facets = c.facets;
  g.neighbour.assign(c.facets.size(), {-1, -1, -1});
  DisjointSets sets(3 * c.facets.size());
  for (const EdgeUse& use : uses) {
    if (use.count != 2 || contains(cuts, use.edge)) continue;
    for (std::size_t s = 0; s < 2; ++s) {
      g.neighbour[at(use.facet[s])][at(use.corner[s])] = use.facet[1 - s];
    }
    join_corners(g, use, sets);
  }
  number_corners(g, sets);
  return g;
}

namespace {

/// Whether facet g runs along the side i of facet f in the opposite sense, as consistent orientation asks.
bool opposed(const Facet& f, int i, const Facet& g) {
  const int from = f[at((i + 1) % 3)];
  const int to = f[at((i + 2) % 3)];
  return g[at((corner_of(g, to) + 1) % 3)] == from;
}

/// Visits the component of `start`; sign is 0 for facets not yet visited. Returns whether it is orientable.
bool flood(const Gluing& g, int start, int region, std::vector<int>& sign, std::vector<int>& of_facet) {
  bool orientable = true;
  std::vector<int> stack{start};
  sign[at(start)] = 1;
  while (!stack.empty()) {
    const int f = stack.back();
    stack.pop_back();
    of_facet[at(f)] = region;
    for (int i = 0; i < 3; ++i) {
      const int n = g.neighbour[at(f)][at(i)];
      if (n < 0) continue;
      const int wanted = opposed(g.facets[at(f)], i, g.facets[at(n)]) ? sign[at(f)] : -sign[at(f)];
      if (sign[at(n)] == 0) {
        sign[at(n)] = wanted;
        stack.push_back(n);
      } else if (sign[at(n)] != wanted) {
        orientable = false;
      }
    }
  }
  return orientable;
}

struct BoundarySide {
  int facet;
  int from;
  int to;  // vertices of the glued surface
};

std::vector<BoundarySide> boundary_sides(const Gluing& g) {
  std::vector<BoundarySide> sides;
  for (std::size_t f = 0; f < g.facets.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (g.neighbour[f][i] >= 0) continue;
      sides.push_back({static_cast<int>(f), g.corner[f][(i + 1) % 3], g.corner[f][(i + 2) % 3]});
    }
  }
  return sides;
}

/// Boundary sides joined where they share a vertex of the glued surface: each class is one loop.
DisjointSets join_sides(const Gluing& g, const std::vector<BoundarySide>& sides) {
  DisjointSets loops(sides.size());
  std::vector<int> first(at(g.corners), -1);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    for (int end : {sides[s].from, sides[s].to}) {
      if (first[at(end)] < 0) {
        first[at(end)] = static_cast<int>(s);
      } else {
        loops.join(at(first[at(end)]), s);
      }
    }
  }
  return loops;
}

/// Adds V - E + F of each region: glued sides count half, the others once.
void add_euler(const Gluing& g, Regions& result) {
  std::vector<char> counted(at(g.corners), 0);
  std::vector<int> doubled(result.types.size(), 0);
  for (std::size_t f = 0; f < g.facets.size(); ++f) {
    int& twice = doubled[at(result.of_facet[f])];
    twice += 2;
    for (std::size_t i = 0; i < 3; ++i) {
      twice -= g.neighbour[f][i] >= 0 ? 1 : 2;
      char& seen = counted[at(g.corner[f][i])];
      if (!seen) twice += 2;
      seen = 1;
    }
  }
  for (std::size_t r = 0; r < doubled.size(); ++r) result.types[r].euler = doubled[r] / 2;
}

}  // namespace

Regions regions(const Gluing& g) {
  Regions result;
  result.of_facet.assign(g.facets.size(), -1);
  std::vector<int> sign(g.facets.size(), 0);
  for (std::size_t f = 0; f < g.facets.size(); ++f) {
    if (sign[f] != 0) continue;
    const int region = static_cast<int>(result.types.size());
    result.types.push_back({});
    result.types.back().orientable = flood(g, static_cast<int>(f), region, sign, result.of_facet);
  }
  add_euler(g, result);
  const std::vector<BoundarySide> sides = boundary_sides(g);
  const DisjointSets loops = join_sides(g, sides);
  for (std::size_t s = 0; s < sides.size(); ++s) {
    if (loops.find(s) == s) ++result.types[at(result.of_facet[at(sides[s].facet)])].loops;
  }
  return result;
}

Signature signature(std::vector<Region> types) {
  std::sort(types.begin(), types.end());
  Signature words;
  for (const Region& r : types) words.insert(words.end(), {r.euler, r.loops, r.orientable ? 1 : 0});
  return words;
}

std::vector<int> boundary_loops(const Gluing& g) {
  const std::vector<BoundarySide> sides = boundary_sides(g);
  const DisjointSets loops = join_sides(g, sides);
  std::vector<int> length(sides.size(), 0);
  for (std::size_t s = 0; s < sides.size(); ++s) ++length[loops.find(s)];
  std::erase(length, 0);
  std::sort(length.begin(), length.end());
  return length;
}

std::vector<std::array<int, 2>> vertex_copies(const Gluing& g) {
  std::vector<std::array<int, 2>> copies;
  copies.reserve(3 * g.facets.size());
  for (std::size_t f = 0; f < g.facets.size(); ++f) {
    for (std::size_t i = 0; i < 3; ++i) copies.push_back({g.facets[f][i], g.corner[f][i]});
  }
  std::sort(copies.begin(), copies.end());
  copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
  return copies;
}

std::vector<int> pinched_vertices(const Gluing& g) {
  const std::vector<std::array<int, 2>> copies = vertex_copies(g);
  std::vector<int> pinched;
  for (std::size_t i = 1; i < copies.size(); ++i) {
    const int v = copies[i][0];
    if (v == copies[i - 1][0] && (pinched.empty() || pinched.back() != v)) pinched.push_back(v);
  }
  return pinched;
}

}  // namespace multimesh::oracle
