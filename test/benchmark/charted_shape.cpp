// SPDX-License-Identifier: BSD-3-Clause
#include "test/benchmark/charted_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace multimesh::bench {

namespace {

using test::Point;
using test::Shape;

constexpr double golden = std::numbers::phi;
constexpr std::array<Point, 12> icosahedron{{{-1, golden, 0},
                                             {1, golden, 0},
                                             {-1, -golden, 0},
                                             {1, -golden, 0},
                                             {0, -1, golden},
                                             {0, 1, golden},
                                             {0, -1, -golden},
                                             {0, 1, -golden},
                                             {golden, 0, -1},
                                             {golden, 0, 1},
                                             {-golden, 0, -1},
                                             {-golden, 0, 1}}};
constexpr std::array<std::array<Index, 3>, 20> icosahedron_faces{
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

/// Vertices of the refined icosahedron, by their barycentric coordinates (in units of 1/n).
class Refinement {
 public:
  explicit Refinement(Shape& s) : shape_(s) {}

  Index vertex(const std::array<Index, 3>& face, const std::array<Index, 3>& weight) {
    std::array<std::uint64_t, 3> words{};
    for (std::size_t i = 0; i < 3; ++i)
      if (weight[i] > 0) words[i] = (std::uint64_t{face[i]} + 1) << 12 | weight[i];
    std::sort(words.begin(), words.end());
    const auto [it, is_new] = known_.try_emplace(words[0] << 40 | words[1] << 20 | words[2],
                                                 static_cast<Index>(shape_.points.size()));
    if (is_new) add_point(face, weight);
    return it->second;
  }

 private:
  void add_point(const std::array<Index, 3>& face, const std::array<Index, 3>& weight) {
    Point p{};
    double length = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) p[k] += weight[i] * icosahedron[face[i]][k];
      length += p[k] * p[k];
    }
    for (double& x : p) x /= std::sqrt(length);
    shape_.points.push_back(p);
  }

  Shape& shape_;
  std::unordered_map<std::uint64_t, Index> known_;
};

std::uint8_t octant(const Shape& s, std::size_t facet) {
  unsigned sign = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0;
    for (const Index v : s.facets.facet(facet)) sum += s.points[v][k];
    sign |= unsigned{sum > 0} << k;
  }
  return static_cast<std::uint8_t>(sign);
}

/// 4 x 2 rectangles of an n x m array of squares.
std::vector<std::uint8_t> rectangles(Index n, Index m) {
  std::vector<std::uint8_t> chart;
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < m; ++j)
      chart.insert(chart.end(), 2, static_cast<std::uint8_t>(4 * i / n * 2 + 2 * j / m));
  return chart;
}

}  // namespace

ChartedShape charted_sphere(Index n) {
  ChartedShape c;
  c.shape.facets.dimension = 2;
  Refinement refinement(c.shape);
  auto& corners = c.shape.facets.corners;
  for (const auto& face : icosahedron_faces)
    for (Index i = 0; i < n; ++i)
      for (Index j = 0; i + j < n; ++j) {
        const auto at = [&](Index p, Index q) { return refinement.vertex(face, {n - p - q, p, q}); };
        corners.insert(corners.end(), {at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 2 <= n) corners.insert(corners.end(), {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  c.shape.facets.vertices = static_cast<Index>(c.shape.points.size());
  for (std::size_t f = 0; f < c.shape.facets.size(); ++f) c.chart.push_back(octant(c.shape, f));
  return c;
}

ChartedShape charted_torus(Index n, Index m) {
  return {test::torus(n, m), rectangles(n, m)};
}

ChartedShape charted_grid(Index n, Index m) {
  return {test::grid(n, m), rectangles(n, m)};
}

Texture texture_of(const ChartedShape& charted) {
  const FacetList& root = charted.shape.facets;
  Texture t{{2, 0, {}}, root};
  std::vector<std::array<Index, 8>> copy(root.vertices);
  for (auto& c : copy) c.fill(no_index);
  for (std::size_t i = 0; i < root.corners.size(); ++i) {
    Index& id = copy[root.corners[i]][charted.chart[i / 3]];
    if (id == no_index) id = t.facets.vertices++;
    t.facets.corners.push_back(id);
  }
  // Where a chart touches itself in a vertex, the vertex is split.
  Cut manifold = cut(t.facets);
  t.facets = std::move(manifold.facets);
  for (std::size_t f = 0; f < t.over.size(); ++f)
    if (manifold.reversed[f]) std::swap(t.over.corners[3 * f], t.over.corners[3 * f + 1]);
  return t;
}

}  // namespace multimesh::bench
