// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that are not manifold, and seams that touch: a reader of the result finds the same topology as a
// reader of the input.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/algorithms/surface_report.hpp"
#include "multimesh/algorithms/surface_topology.hpp"
#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {
namespace {

/// Components of a graph given by its edges.
std::size_t components(const std::set<std::array<int, 2>>& edges) {
  std::map<int, int> above;
  const auto top = [&](int v) {
    above.try_emplace(v, v);
    while (above[v] != v) v = above[v];
    return v;
  };
  for (const auto& e : edges) {
    const int a = top(e[0]), b = top(e[1]);
    if (a != b) above[a] = b;
  }
  return static_cast<std::size_t>(
      std::count_if(above.begin(), above.end(), [](auto& p) { return p.first == p.second; }));
}

/// Of triangles by the numbers of their positions.
struct Joined {
  std::size_t components = 0, boundary_loops = 0;
  long euler = 0;
  std::map<int, int> crowded;  ///< edges by their number of triangles, from 3 on
  friend bool operator==(const Joined&, const Joined&) = default;
  friend void PrintTo(const Joined& j, std::ostream* out) {
    *out << j.components << " components, " << j.boundary_loops << " loops, Euler " << j.euler;
    for (const auto& [faces, n] : j.crowded) *out << "; " << n << " edges of " << faces;
  }
};

Joined joined(const TexturedTriangles& s) {
  std::map<std::array<int, 2>, int> faces;
  std::set<int> vertices;
  for (const auto& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = t[i].position, b = t[(i + 1) % 3].position;
      vertices.insert(a);
      ++faces[{std::min(a, b), std::max(a, b)}];
    }
  Joined j;
  std::set<std::array<int, 2>> all, rim;
  for (const auto& [e, n] : faces) {
    all.insert(e);
    if (n == 1) rim.insert(e);
    if (n > 2) ++j.crowded[n];
  }
  j.components = components(all), j.boundary_loops = components(rim);
  j.euler = long(vertices.size()) - long(faces.size()) + long(s.triangles.size());
  return j;
}

/// The outside of random small cubes that are stacked: they meet in faces, edges and corners. Each face is a
/// grid of n x n squares.
TexturedTriangles touching_cubes(unsigned seed, int n) {
  std::mt19937 random(seed);
  constexpr int size = 3;
  std::set<std::array<int, 3>> cubes;
  for (int i = 0; i < 11; ++i)
    cubes.insert({int(random() % size), int(random() % size), int(random() % size)});
  TexturedTriangles out;
  std::map<std::array<int, 3>, int> number;
  const auto vertex = [&](const std::array<int, 3>& p) {
    const auto [it, is_new] = number.try_emplace(p, int(out.positions.size()));
    if (is_new) out.positions.emplace_back(double(p[0]) / n, double(p[1]) / n, double(p[2]) / n);
    return it->second;
  };
  for (const auto& cube : cubes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        auto beyond = cube;
        beyond[axis] += 2 * side - 1;
        if (cubes.contains(beyond)) continue;
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            const auto corner = [&](int di, int dj) {
              std::array<int, 3> p{};
              p[axis] = n * (cube[axis] + side), p[u] = n * cube[u] + i + di, p[v] = n * cube[v] + j + dj;
              return vertex(p);
            };
            std::array<int, 4> q{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
            if (side == 0) std::swap(q[1], q[3]);
            for (const auto& t : {std::array{q[0], q[1], q[2]}, std::array{q[0], q[2], q[3]}}) {
              auto& c = out.triangles.emplace_back();
              for (std::size_t k = 0; k < 3; ++k) c[k] = {t[k], -1};
            }
          }
      }
  return out;
}

/// Pages that share a spine; the vertices of each are displaced a little.
TexturedTriangles pages(unsigned seed, int sheets, int n) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> little(-0.15, 0.15);
  TexturedTriangles out;
  for (int j = 0; j <= n; ++j) out.positions.emplace_back(0, 0, j);
  for (int k = 0; k < sheets; ++k) {
    const double angle = 2 * 3.14159 * k / sheets;
    const int first = int(out.positions.size()) - (n + 1);
    for (int i = 1; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        out.positions.emplace_back(i * std::cos(angle) + little(random), i * std::sin(angle) + little(random),
                                   j + (j % n == 0 ? 0 : little(random)));
    const auto at = [&](int i, int j) { return i == 0 ? j : first + i * (n + 1) + j; };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (const auto& t : {std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                              std::array{at(i, j), at(i + 1, j + 1), at(i, j + 1)}}) {
          auto& c = out.triangles.emplace_back();
          for (std::size_t m = 0; m < 3; ++m) c[m] = {t[m], -1};
        }
  }
  return out;
}

/// Two balls of which some vertices are one.
TexturedTriangles pinched_balls(unsigned seed, std::size_t points) {
  std::mt19937 random(seed);
  TexturedTriangles out = bare(sphere(2));
  const TexturedTriangles ball = out;
  const int n = int(ball.positions.size());
  std::map<int, int> shared;
  while (shared.size() < points) {
    const int v = int(random() % unsigned(n));
    shared.emplace(v, v);
  }
  for (Vec3 p : ball.positions) out.positions.push_back(p * 1.5);
  for (auto t : ball.triangles) {
    for (auto& c : t) c.position = shared.contains(c.position) ? c.position : c.position + n;
    out.triangles.push_back(t);
  }
  return out;
}

Joined told(const SurfaceTopology& t) {
  Joined j;
  j.components = t.components, j.boundary_loops = t.boundary_loops, j.euler = t.euler_characteristic;
  return j;
}

void expect_told_rightly(const TexturedTriangles& in) {
  const SurfaceTopology t = topology_of(TexturedSurface(in));
  Joined right = joined(in);
  std::size_t crowded = 0;
  for (const auto& [faces, n] : right.crowded) crowded += std::size_t(n);
  right.crowded.clear();
  EXPECT_EQ(told(t), right);
  EXPECT_EQ(t.crowded_edges, crowded);
  EXPECT_EQ(t.faces, in.triangles.size());
}

void expect_same_joined(const TexturedTriangles& in, double length) {
  TexturedSurface surface(in);
  RemeshOptions options;
  options.length = length;
  options.iterations = 4;
  (void)remesh(surface, options);
  std::vector<Index> source;
  EXPECT_EQ(joined(surface.triangles(source)), joined(in)) << "length " << length;
}

class NotManifold : public testing::TestWithParam<unsigned> {};

TEST_P(NotManifold, TheTopologyOfTheJoinedSurfaceIsTold) {
  expect_told_rightly(touching_cubes(GetParam(), 2));
  expect_told_rightly(pages(GetParam(), 3 + int(GetParam() % 3), 4));
  expect_told_rightly(pinched_balls(GetParam(), 1 + GetParam()));
}

TEST_P(NotManifold, CubesThatTouchStayApart) {
  for (const double length : {0.15, 0.25, 0.5}) expect_same_joined(touching_cubes(GetParam(), 4), length);
}

TEST_P(NotManifold, PagesKeepTheirSpine) {
  for (const int sheets : {3, 4, 5})
    for (const double length : {0.5, 1.0, 2.2}) expect_same_joined(pages(GetParam(), sheets, 6), length);
}

TEST_P(NotManifold, BallsKeepThePointsThatTheyShare) {
  for (const double length : {0.1, 0.3, 0.8})
    expect_same_joined(pinched_balls(GetParam(), 1 + GetParam()), length);
}

TEST_P(NotManifold, DecimationKeepsThemToo) {
  for (const TexturedTriangles& in :
       {touching_cubes(GetParam(), 4), pages(GetParam(), 4, 6), pinched_balls(GetParam(), 1 + GetParam())}) {
    TexturedSurface surface(in);
    DecimateOptions options;
    options.faces = in.triangles.size() / 4;
    (void)decimate(surface, options);
    std::vector<Index> source;
    EXPECT_EQ(joined(surface.triangles(source)), joined(in));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, NotManifold, testing::Range(0U, 8U));

/// A ball in many charts. The texture coordinates of a chart are moved by a vector of its own where a vertex
/// is open; at the others its charts touch.
TexturedTriangles charts_that_touch(unsigned seed, std::size_t charts, unsigned open_in_ten) {
  std::mt19937 random(seed);
  TexturedTriangles out = bare(sphere(3));
  std::vector<std::size_t> chart(out.triangles.size());
  for (auto& c : chart) c = random() % charts;
  std::vector<bool> open;
  for (std::size_t v = 0; v < out.positions.size(); ++v) open.push_back(random() % 10 < open_in_ten);
  add_texture(out, [&](std::size_t t, const Vec3& p) {
    const auto v = std::find(out.positions.begin(), out.positions.end(), p) - out.positions.begin();
    const Vec2 flat(std::atan2(p[1], p[0]) + 0.1 * p[2], p[2]);
    const double step = open[std::size_t(v)] ? 1e-3 * double(chart[t] + 1) : 0;
    return flat + Vec2(step, -step);
  });
  return out;
}

TEST(JoinedSurface, WhatDiffersIsNamed) {
  const SurfaceTopology cubes = topology_of(TexturedSurface(touching_cubes(1, 2)));
  EXPECT_TRUE(differences(cubes, topology_of(TexturedSurface(touching_cubes(1, 3)))).empty());
  const std::vector<std::string> list = differences(cubes, topology_of(TexturedSurface(pages(1, 3, 2))));
  const auto named = [&](const std::string& what) {
    return std::any_of(list.begin(), list.end(), [&](const std::string& s) { return s.starts_with(what); });
  };
  EXPECT_TRUE(named("Euler characteristic: "));
  EXPECT_TRUE(named("boundary loops: 0 became 1"));
  EXPECT_TRUE(named("edges with three or more faces: "));
}

TEST(JoinedSurface, SeamsWithEqualSidesAreCounted) {
  TexturedSurface surface(two_charts().input);
  EXPECT_EQ(topology_of(surface).closed_seams, 0U);
  const SurfaceTopology before = topology_of(surface);
  for (Vec2& p : surface.texcoords()) p = Vec2(0, 0);
  EXPECT_GT(topology_of(surface).closed_seams, 0U);
  EXPECT_EQ(differences(before, topology_of(surface)).size(), 1U);
}

class ManyCharts : public testing::TestWithParam<unsigned> {};

TEST_P(ManyCharts, StayOpenWhenTheResultIsReadAgain) {
  for (const std::size_t charts : {3U, 40U})
    for (const unsigned open : {2U, 5U})
      for (const double length : {0.1, 0.3}) {
        TexturedSurface surface(charts_that_touch(GetParam(), charts, open));
        const SurfaceReport before = report(surface);
        RemeshOptions options;
        options.length = length;
        options.iterations = 3;
        (void)remesh(surface, options);
        std::vector<Index> source;
        const SurfaceReport after = report(TexturedSurface(surface.triangles(source)));
        EXPECT_EQ(after.texture->components, before.texture->components)
            << charts << ' ' << open << ' ' << length;
        EXPECT_EQ(after.texture->euler_characteristic, before.texture->euler_characteristic);
        EXPECT_EQ(after.seams->curves, before.seams->curves);
        EXPECT_EQ(after.seams->ends, before.seams->ends);
        EXPECT_EQ(after.seams->junctions, before.seams->junctions);
      }
}

INSTANTIATE_TEST_SUITE_P(Seeds, ManyCharts, testing::Range(0U, 4U));

__extension__ using Exact = __float128;  // products of differences of doubles near 1 fit

int side(const TexturedTriangles& s, std::size_t t) {
  const auto at = [&](std::size_t i) { return s.texcoords[std::size_t(s.triangles[t][i].texcoord)]; };
  const Vec2 a = at(0), b = at(1), c = at(2);
  const Exact left = (Exact(b[0]) - a[0]) * (Exact(c[1]) - a[1]),
              right = (Exact(b[1]) - a[1]) * (Exact(c[0]) - a[0]);
  return (left > right) - (left < right);
}

// Texture triangles that are so thin that rounding decides on which side of an edge its middle lies.
TEST(ThinTexture, NoTriangleTurnsOver) {
  for (const double width : {1e-3, 1e-10, 1e-15, 3e-16, 1e-16})
    for (const double length : {0.3, 0.9, 2.5}) {
      TexturedTriangles in = bare(grid(12, 12));
      add_texture(in, [&](std::size_t, const Vec3& p) {
        return Vec2(0.3 + p[0] / 37 - width * p[1] / 3, 0.1 + p[0] / 53 + width * p[1]);
      });
      TexturedSurface surface(in);
      RemeshOptions options;
      options.length = length;
      options.iterations = 3;
      (void)remesh(surface, options);
      std::vector<Index> source;
      const TexturedTriangles out = surface.triangles(source);
      std::size_t wrong = 0, right = 0;
      for (std::size_t t = 0; t < out.triangles.size(); ++t)
        if (side(in, source[t]) != 0) (side(out, t) == side(in, source[t]) ? right : wrong)++;
      EXPECT_EQ(wrong, 0U) << "width " << width << ", length " << length;
      EXPECT_GT(right, 0U);
    }
}

}  // namespace
}  // namespace multimesh::test
