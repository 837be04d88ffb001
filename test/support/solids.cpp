// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/solids.hpp"

#include <algorithm>

namespace multimesh::test {

namespace {

void add(FacetList& list, Tetrahedron t) {
  list.corners.insert(list.corners.end(), t.begin(), t.end());
}

/// Turns facets until neighbours agree; connected components one by one. Quadratic.
void orient(FacetList& list) {
  const std::size_t n = list.size();
  const auto turn = [&](std::size_t f) { std::swap(list.corners[4 * f], list.corners[4 * f + 1]); };
  /// The vertices of f that are not in g first; whether the order is an even permutation of f's own.
  const auto sign = [&](std::size_t f, Index missing) {
    const auto v = list.facet(f);
    bool even = (std::find(v.begin(), v.end(), missing) - v.begin()) % 2 == 0;
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (v[i] != missing && v[j] != missing && v[i] > v[j]) even = !even;
    return even;
  };
  const auto missing = [&](std::size_t f, std::size_t g) {
    Index only = no_index;
    int count = 0;
    for (const Index v : list.facet(f))
      if (std::find(list.facet(g).begin(), list.facet(g).end(), v) == list.facet(g).end()) only = v, ++count;
    return count == 1 ? only : no_index;
  };
  std::vector<bool> seen(n, false);
  for (std::size_t start = 0; start < n; ++start) {
    if (seen[start]) continue;
    std::vector<std::size_t> queue{start};
    seen[start] = true;
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (std::size_t g = 0; g < n; ++g) {
        const std::size_t f = queue[q];
        const Index a = missing(f, g), b = missing(g, f);
        if (seen[g] || a == no_index) continue;
        if (sign(f, a) == sign(g, b)) turn(g);
        seen[g] = true;
        queue.push_back(g);
      }
  }
}

/// The six tetrahedra of a cube from corner 000 to corner 111; corner(x, y, z) is a vertex.
template <class Corner>
void add_cube(FacetList& list, const Corner& corner) {
  std::array<int, 3> order{0, 1, 2};
  bool even = true;
  do {
    std::array<Index, 3> at{};
    Tetrahedron t{corner(0, 0, 0)};
    for (std::size_t step = 0; step < 3; ++step) {
      at[static_cast<std::size_t>(order[step])] = 1;
      t[step + 1] = corner(at[0], at[1], at[2]);
    }
    even = (order[1] == (order[0] + 1) % 3);
    if (!even) std::swap(t[2], t[3]);
    add(list, t);
  } while (std::next_permutation(order.begin(), order.end()));
}

}  // namespace

Shape tetrahedra(std::initializer_list<Tetrahedron> list) {
  Shape s{{3, 0, {}}, {}};
  for (const Tetrahedron& t : list) add(s.facets, t);
  s.facets.vertices = *std::max_element(s.facets.corners.begin(), s.facets.corners.end()) + 1;
  orient(s.facets);
  for (Index v = 0; v < s.facets.vertices; ++v)
    s.points.push_back({double(v), double(v * v % 7), double(v * v * v % 11)});
  return s;
}

Shape single_tet() {
  return tetrahedra({{0, 1, 2, 3}});
}
Shape one_ear() {
  return tetrahedra({{0, 1, 2, 3}, {0, 2, 3, 4}});
}
Shape two_ears() {
  return tetrahedra({{0, 1, 2, 3}, {0, 2, 3, 4}, {0, 1, 3, 5}});
}
Shape three_incident_tets() {
  return tetrahedra({{0, 1, 2, 3}, {0, 2, 3, 4}, {2, 3, 4, 5}});
}
Shape three_cycle() {
  return tetrahedra({{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 2}});
}
Shape four_cycle() {
  return tetrahedra({{0, 1, 2, 3}, {0, 1, 3, 4}, {0, 1, 4, 5}, {0, 1, 5, 2}});
}
Shape six_cycle() {
  return tetrahedra({{0, 1, 2, 3}, {0, 2, 3, 4}, {2, 3, 4, 5}, {2, 3, 5, 7}, {2, 3, 6, 7}, {1, 2, 3, 6}});
}

namespace {

/// n x m x l cubes over vertices numbered by `vertex(i, j, k)`.
template <class Numbering>
FacetList cubes(Index n, Index m, Index l, Index vertices, const Numbering& vertex) {
  FacetList list{3, vertices, {}};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j)
      for (Index k = 0; k < l; ++k)
        add_cube(list, [&](Index x, Index y, Index z) { return vertex(i + x, j + y, k + z); });
  return list;
}

}  // namespace

Shape box(Index n, Index m, Index l) {
  Shape s{cubes(n, m, l, (n + 1) * (m + 1) * (l + 1),
                [&](Index i, Index j, Index k) { return (i * (m + 1) + j) * (l + 1) + k; }),
          {}};
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= m; ++j)
      for (Index k = 0; k <= l; ++k) s.points.push_back({double(i), double(j), double(k)});
  return s;
}

Shape torus3(Index n) {
  Shape s{
      cubes(n, n, n, n * n * n, [&](Index i, Index j, Index k) { return (i % n * n + j % n) * n + k % n; }),
      {}};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      for (Index k = 0; k < n; ++k) s.points.push_back({double(i), double(j), double(k)});
  return s;
}

Tile tile_of_torus3(Index n) {
  Tile t{box(n, n, n), {3, n * n * n, {}}};
  for (const Index v : t.grid.facets.corners) {
    const Index i = v / (n + 1) / (n + 1), j = v / (n + 1) % (n + 1), k = v % (n + 1);
    t.over.corners.push_back((i % n * n + j % n) * n + k % n);
  }
  return t;
}

// Prisms are cut with ascending vertices, so that they fit.
Shape layers(const Shape& surface, Index n) {
  const Index size = surface.facets.vertices;
  Shape s{{3, size * (n + 1), {}}, {}};
  for (Index l = 0; l < n; ++l)
    for (std::size_t f = 0; f < surface.facets.size(); ++f) {
      const auto v = surface.facets.facet(f);
      std::array<Index, 3> low{v[0], v[1], v[2]};
      std::sort(low.begin(), low.end());
      for (Index& x : low) x += l * size;
      const Index a = low[0], b = low[1], c = low[2];
      add(s.facets, {a, b, c, c + size});
      add(s.facets, {a, b, b + size, c + size});
      add(s.facets, {a, a + size, b + size, c + size});
    }
  orient(s.facets);
  for (Index l = 0; l <= n; ++l)
    for (const Point& p : surface.points) {
      const double scale = 1 + 0.5 * l;
      s.points.push_back({scale * p[0], scale * p[1], scale * p[2] + 0.25 * l});
    }
  return s;
}

Shape cone(const Shape& surface) {
  Shape s{{3, surface.facets.vertices + 1, {}}, surface.points};
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto v = surface.facets.facet(f);
    add(s.facets, {v[0], v[1], v[2], surface.facets.vertices});
  }
  s.points.push_back({0.125, 0.25, 0.5});
  return s;
}

}  // namespace multimesh::test
