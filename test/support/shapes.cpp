// SPDX-License-Identifier: BSD-3-Clause
#include "test/support/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace multimesh::test {

namespace {

void add(FacetList& list, Index a, Index b, Index c) {
  list.corners.insert(list.corners.end(), {a, b, c});
}

/// The triangles of an n x m array of squares over vertices numbered by `vertex(i, j)`.
template <class Numbering>
FacetList squares(Index n, Index m, Index vertices, const Numbering& vertex) {
  FacetList list{2, vertices, {}};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j) {
      const Index a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
      add(list, a, b, c);
      add(list, a, c, d);
    }
  return list;
}

}  // namespace

Shape grid(Index n, Index m) {
  Shape s{squares(n, m, (n + 1) * (m + 1), [&](Index i, Index j) { return i * (m + 1) + j; }), {}};
  for (Index i = 0; i <= n; ++i)
    for (Index j = 0; j <= m; ++j) s.points.push_back({double(i), double(j), 0});
  return s;
}

Shape annulus(Index n, Index m) {
  Shape s{squares(n, m, n * (m + 1), [&](Index i, Index j) { return i % n * (m + 1) + j; }), {}};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j <= m; ++j) {
      const double angle = 2 * std::numbers::pi * i / n, r = 1 + double(j) / m;
      s.points.push_back({r * std::cos(angle), r * std::sin(angle), 0});
    }
  return s;
}

Shape torus(Index n, Index m) {
  Shape s{squares(n, m, n * m, [&](Index i, Index j) { return i % n * m + j % m; }), {}};
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j) {
      const double u = 2 * std::numbers::pi * i / n, v = 2 * std::numbers::pi * j / m, r = 2 + std::cos(v);
      s.points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
    }
  return s;
}

Shape sphere(int levels) {
  Shape s{{2, 6, {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5}},
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::array<Index, 2>, Index> middle;
    const auto mid = [&](Index a, Index b) {
      const auto [it, is_new] = middle.try_emplace({std::min(a, b), std::max(a, b)}, s.points.size());
      if (is_new) {
        Point p{};
        double length = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          p[i] = s.points[a][i] + s.points[b][i];
          length += p[i] * p[i];
        }
        for (double& x : p) x /= std::sqrt(length);
        s.points.push_back(p);
      }
      return it->second;
    };
    FacetList fine{2, 0, {}};
    for (std::size_t f = 0; f < s.facets.size(); ++f) {
      const auto v = s.facets.facet(f);
      const Index ab = mid(v[0], v[1]), bc = mid(v[1], v[2]), ca = mid(v[2], v[0]);
      add(fine, v[0], ab, ca), add(fine, ab, v[1], bc), add(fine, ca, bc, v[2]), add(fine, ab, bc, ca);
    }
    s.facets = std::move(fine);
    s.facets.vertices = static_cast<Index>(s.points.size());
  }
  return s;
}

Shape disk(Index n) {
  Shape s{{2, n + 2, {}}, {{0, 0, 0}}};
  for (Index i = 0; i <= n; ++i) {
    const double angle = 1.5 * std::numbers::pi * i / n;
    s.points.push_back({std::cos(angle), std::sin(angle), 0});
    if (i > 0) add(s.facets, 0, i, i + 1);
  }
  return s;
}

Tile tile_of_torus(Index n, Index m) {
  Tile t{grid(n, m), {2, n * m, {}}};
  for (const Index v : t.grid.facets.corners) t.over.corners.push_back(v / (m + 1) % n * m + v % (m + 1) % m);
  return t;
}

std::vector<std::array<Index, 2>> edges_of(const FacetList& triangles) {
  std::vector<std::array<Index, 2>> edges;
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t i = 0; i < 3; ++i) {
      const Index a = triangles.facet(f)[i], b = triangles.facet(f)[(i + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b)});
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace multimesh::test
