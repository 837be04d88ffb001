// SPDX-License-Identifier: BSD-3-Clause
// The oracle: n-2 triangles whose directed edges, after inner ones cancel, are the polygon's; for simple
// polygons also no flipped triangle, and areas that add up to the polygon's.
#include <cmath>
#include <ctime>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "io_fixture.hpp"
#include "multimesh/io/obj_reader.hpp"
#include "multimesh/io/triangulate.hpp"

namespace multimesh::io::test {
namespace {

using Point = std::array<double, 3>;
using Corner = PolygonSoup::Corner;

PolygonSoup one_polygon(std::vector<Point> points, std::vector<std::int32_t> order = {}) {
  PolygonSoup soup;
  soup.positions = std::move(points);
  if (order.empty()) {
    order.resize(soup.positions.size());
    std::iota(order.begin(), order.end(), 0);
  }
  // The texture index is the place in the polygon: it tells corners of one vertex apart.
  for (std::size_t i = 0; i < order.size(); ++i)
    soup.corners.push_back({order[i], static_cast<std::int32_t>(i), -1});
  soup.face_begin.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  return soup;
}

Point cross(const Point& o, const Point& a, const Point& b) {
  const double u[3] = {a[0] - o[0], a[1] - o[1], a[2] - o[2]}, v[3] = {b[0] - o[0], b[1] - o[1], b[2] - o[2]};
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
double dot(const Point& a, const Point& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

const Point& at(const PolygonSoup& soup, const Corner& c) {
  return soup.positions[static_cast<std::size_t>(c.v)];
}

Point vector_area(const PolygonSoup& soup, std::span<const Corner> f) {
  Point sum{};
  for (std::size_t i = 1; i + 1 < f.size(); ++i) {
    const Point n = cross(at(soup, f[0]), at(soup, f[i]), at(soup, f[i + 1]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += n[k];
  }
  return sum;
}

void expect_edges_kept(const PolygonSoup& soup, const TriangleSoup& cut) {
  std::map<std::array<std::int32_t, 3>, int> edges;  // polygon, from, to
  const auto add = [&](std::int32_t f, const Corner& a, const Corner& b, int n) {
    (edges[{f, a.vt, b.vt}] += n), (edges[{f, b.vt, a.vt}] -= n);
  };
  std::vector<std::size_t> count(soup.face_count());
  for (std::size_t t = 0; t < cut.triangles.size(); ++t) {
    const auto f = static_cast<std::int32_t>(cut.polygon[t]);
    ++count[cut.polygon[t]];
    for (std::size_t k = 0; k < 3; ++k) add(f, cut.triangles[t][k], cut.triangles[t][(k + 1) % 3], 1);
  }
  for (std::size_t f = 0; f < soup.face_count(); ++f) {
    const auto face = soup.face(f);
    EXPECT_EQ(count[f], face.size() - 2);
    for (std::size_t k = 0; k < face.size(); ++k)
      add(static_cast<std::int32_t>(f), face[k], face[(k + 1) % face.size()], -1);
  }
  for (const auto& [edge, n] : edges) EXPECT_EQ(n, 0) << edge[1] << " " << edge[2];
}

void expect_simple_cut(const PolygonSoup& soup) {
  const TriangleSoup cut = triangulate(soup);
  expect_edges_kept(soup, cut);
  const Point normal = vector_area(soup, soup.face(0));
  const double length = std::sqrt(dot(normal, normal));
  double sum = 0;
  for (const auto& t : cut.triangles) {
    const double area = dot(cross(at(soup, t[0]), at(soup, t[1]), at(soup, t[2])), normal) / length;
    EXPECT_GT(area, -1e-12 * length);
    EXPECT_TRUE(t[0].v != t[1].v && t[1].v != t[2].v && t[2].v != t[0].v);
    sum += std::abs(area);
  }
  EXPECT_NEAR(sum, length, 1e-12 * length + 1e-15);  // of polygons of size 1 or more
}

/// A rotation and shift into general position.
std::vector<Point> placed(const std::vector<std::array<double, 2>>& plane, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Point u{normal(random), normal(random), normal(random)}, w{normal(random), normal(random), normal(random)};
  const double scale = 1 / std::sqrt(dot(u, u));
  for (double& x : u) x *= scale;
  const double along = dot(u, w);
  for (std::size_t k = 0; k < 3; ++k) w[k] -= along * u[k];
  const double unit = 1 / std::sqrt(dot(w, w));
  std::vector<Point> points;
  for (const auto& [a, b] : plane)
    points.push_back(
        {3 + a * u[0] + b * w[0] * unit, a * u[1] + b * w[1] * unit, a * u[2] + b * w[2] * unit});
  return points;
}

TEST(Triangulate, TrianglesAreKept) {
  const PolygonSoup soup = one_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const TriangleSoup cut = triangulate(soup);
  ASSERT_EQ(cut.triangles.size(), 1U);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(cut.triangles[0][k], soup.corners[k]);
}

TEST(Triangulate, RandomStarPolygonsInSpace) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> radius(0.05, 1), jitter(0.1, 0.9);
  for (int run = 0; run < 500; ++run) {
    SCOPED_TRACE(run);
    const std::size_t n = 4 + random() % 40;
    std::vector<std::array<double, 2>> plane;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle =
          2 * std::numbers::pi * (static_cast<double>(i) + jitter(random)) / static_cast<double>(n);
      const double r = radius(random);
      plane.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    const PolygonSoup soup = one_polygon(placed(plane, random));
    // A star of few corners may not contain its centre and turn over; its area tells.
    expect_simple_cut(soup);
  }
}

TEST(Triangulate, SpiralsAndCombs) {
  std::vector<Point> spiral, comb;
  for (int i = 0; i < 60; ++i)
    spiral.push_back({(1 + i) * std::cos(0.3 * i), (1 + i) * std::sin(0.3 * i), 2});
  for (int i = 59; i >= 0; --i)
    spiral.push_back({(3 + i) * std::cos(0.3 * i), (3 + i) * std::sin(0.3 * i), 2});
  for (int i = 0; i < 40; ++i) comb.push_back({i * 1.0, i % 2 ? 1.0 : 9.0, 0});
  comb.push_back({39, 0, 0});
  comb.push_back({0, 0, 0});
  expect_simple_cut(one_polygon(spiral));
  expect_simple_cut(one_polygon(comb));
}

TEST(Triangulate, SquareWithAHoleJoinedByADoubledEdge) {
  const std::vector<Point> points = {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0},
                                     {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}};
  expect_simple_cut(one_polygon(points, {0, 1, 2, 3, 0, 4, 5, 6, 7, 4}));
}

TEST(Triangulate, CornersInAStraightLineGiveNoFlatTriangleWhereThereIsAChoice) {
  const PolygonSoup soup = one_polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}});
  for (const auto& t : triangulate(soup).triangles)
    EXPECT_GT(cross(at(soup, t[0]), at(soup, t[1]), at(soup, t[2]))[2], 0);
  expect_simple_cut(soup);
}

TEST(Triangulate, ConcaveQuadsAreCutAtTheReflexCornerAndConvexOnesAlongTheShorterDiagonal) {
  const std::vector<Point> dart = {{0, 0, 0}, {4, -3, 0}, {1, 0, 0}, {4, 3, 0}};
  for (std::int32_t shift = 0; shift < 4; ++shift)
    expect_simple_cut(one_polygon(dart, {shift, (shift + 1) % 4, (shift + 2) % 4, (shift + 3) % 4}));
  const PolygonSoup kite = one_polygon({{0, 0, 0}, {2, -1, 0}, {5, 0, 0}, {2, 1, 0}});
  for (const auto& t : triangulate(kite).triangles) {
    int short_ends = 0;
    for (const Corner& c : t) short_ends += c.v == 1 || c.v == 3;
    EXPECT_EQ(short_ends, 2);
  }
}

TEST(Triangulate, NothingIsLostOfPolygonsThatCrossThemselvesOrAreFlat) {
  std::mt19937 random(5);
  for (int run = 0; run < 500; ++run) {
    SCOPED_TRACE(run);
    const std::size_t n = 4 + random() % 12;
    std::vector<Point> points;
    for (std::size_t i = 0; i < n; ++i)
      points.push_back({static_cast<double>(random() % 3), run % 2 ? 0 : static_cast<double>(random() % 3),
                        run % 3 ? 0 : static_cast<double>(random() % 3)});
    const PolygonSoup soup = one_polygon(points);
    expect_edges_kept(soup, triangulate(soup));
  }
}

TEST(Triangulate, PolygonThatVisitsAVertexTwiceAvoidsPinchedTriangles) {
  const PolygonSoup soup = one_polygon({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 0, 2});
  for (const auto& t : triangulate(soup).triangles)
    EXPECT_TRUE(t[0].v != t[1].v && t[1].v != t[2].v && t[2].v != t[0].v);
}

using Plane = std::vector<std::array<double, 2>>;

Plane ring(std::size_t n, const std::function<std::array<double, 2>(double part)>& at) {
  Plane plane;
  for (std::size_t i = 0; i < n; ++i) plane.push_back(at(static_cast<double>(i) / static_cast<double>(n)));
  return plane;
}

/// Out along one side and back along the other, `width` apart.
Plane band(std::size_t n, double width, const std::function<std::array<double, 2>(double part)>& middle) {
  Plane plane;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = i < n / 2 ? i : n - 1 - i;
    const auto [x, y] = middle(static_cast<double>(k) / static_cast<double>(n / 2));
    const double length = std::hypot(x, y), away = (i < n / 2 ? width : 0) / length;
    plane.push_back({x * (1 + away), y * (1 + away)});
  }
  return plane;
}

/// Large polygons of many kinds, all simple but for touching themselves along the edges that lead to holes.
std::vector<std::pair<std::string, PolygonSoup>> large_polygons(std::size_t n) {
  constexpr double turn = 2 * std::numbers::pi;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.05, 1);
  std::vector<std::pair<std::string, PolygonSoup>> all;
  const auto add = [&](const char* name, const Plane& plane) {
    all.emplace_back(name, one_polygon(placed(plane, random)));
  };
  const auto on_circle = [&](double t) { return std::array{std::cos(turn * t), std::sin(turn * t)}; };
  add("circle", ring(n, on_circle));
  add("needle", ring(n, [](double t) { return std::array{std::cos(turn * t), 1e-7 * std::sin(turn * t)}; }));
  add("star", ring(n, [&](double t) {
        const double r = radius(random);
        return std::array{r * std::cos(turn * t), r * std::sin(turn * t)};
      }));
  add("gear", ring(n, [&](double t) {
        const double r = static_cast<int>(t * static_cast<double>(n) + 0.5) % 4 < 2 ? 1 : 0.9;
        return std::array{r * std::cos(turn * t), r * std::sin(turn * t)};
      }));
  add("square", ring(n, [](double t) {
        const double s = 4 * t - std::floor(4 * t);
        return std::array<std::array<double, 2>, 4>{
            {{s, 0}, {1, s}, {1 - s, 1}, {0, 1 - s}}}[static_cast<std::size_t>(4 * t)];
      }));
  add("spiral", band(n, 0.5, [](double t) {
        const double r = 1 + 40 * t;
        return std::array{r * std::cos(turn * 40 * t), r * std::sin(turn * 40 * t)};
      }));
  Plane comb;
  for (std::size_t i = 0; i < n; ++i) comb.push_back({static_cast<double>(n - i), i % 2 ? 1.0 : 1000.0});
  comb.push_back({1, 0});
  comb.push_back({static_cast<double>(n), 0});
  add("comb", comb);
  return all;
}

TEST(Triangulate, LargePolygonsInAMoment) {
  for (const auto& [name, soup] : large_polygons(100000)) {
    SCOPED_TRACE(name);
    const std::clock_t begin = std::clock();
    const TriangleSoup cut = triangulate(soup);
    EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
    EXPECT_EQ(cut.triangles.size(), soup.corners.size() - 2);
  }
  for (const auto& [name, soup] : large_polygons(5000)) {
    SCOPED_TRACE(name);
    expect_simple_cut(soup);
  }
}

// 3---------------------------2   Each hole is joined to the one before, the first to corner 0: there along
// |  +---+    +---+    +---+  |   its left, upper and right side, back along the lower ones.
// |  |   |    |   |    |   |  |
// |  +---+----+---+----+---+  |
// 0---------------------------1
PolygonSoup row_of_holes(std::int32_t holes) {
  std::vector<Point> points = {{0, 0, 0}, {1.0 * holes, 0, 0}, {1.0 * holes, 1, 0}, {0, 1, 0}};
  std::vector<std::int32_t> order = {0};
  for (std::int32_t h = 0; h < holes; ++h)
    for (const auto& [x, y] : {std::pair{0.3, 0.3}, {0.3, 0.7}, {0.7, 0.7}, {0.7, 0.3}}) {
      order.push_back(static_cast<std::int32_t>(points.size()));
      points.push_back({h + x, y, 0});
    }
  for (std::int32_t h = holes - 1; h >= 0; --h) {
    if (h + 1 < holes) order.push_back(4 + 4 * h + 3);
    order.push_back(4 + 4 * h);
  }
  order.insert(order.end(), {0, 1, 2, 3});
  return one_polygon(points, order);
}

TEST(Triangulate, ManyHolesJoinedByDoubledEdges) {
  for (const std::int32_t holes : {1, 2, 7, 500}) {
    SCOPED_TRACE(holes);
    expect_simple_cut(row_of_holes(holes));
  }
  const std::clock_t begin = std::clock();
  triangulate(row_of_holes(15000));
  EXPECT_LT(std::clock() - begin, 5 * CLOCKS_PER_SEC);
}

TEST(Triangulate, ConcavePolygonOfTheSharedData) {
  const fs::path root = shared("textured");
  if (root.empty()) GTEST_SKIP() << "no shared data";
  PolygonSoup soup = read_obj(root / "small_cases" / "concave_polygon" / "concave_polygon.obj");
  for (std::size_t i = 0; i < soup.corners.size(); ++i) soup.corners[i].vt = static_cast<std::int32_t>(i);
  expect_simple_cut(soup);
}

}  // namespace
}  // namespace multimesh::io::test
