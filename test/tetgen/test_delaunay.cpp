// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <thread>

#include "multimesh/error.hpp"
#include "multimesh/tetgen/delaunay.hpp"
#include "test/tetgen/tet_facts.hpp"

namespace multimesh::test {

using tetgen::delaunay;
using tetgen::DelaunayMesh;
using tetgen::DelaunayOptions;
using tetgen::Point;

namespace {

std::vector<Point> random_points(std::size_t count, unsigned seed, double scale = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> coordinate(0, scale);
  std::vector<Point> points(count);
  for (Point& p : points)
    for (double& x : p) x = coordinate(random);
  return points;
}

/// All that holds for any input: positive, conforming, a box that is filled, no point lost.
void expect_filled_box(const DelaunayMesh& mesh, std::span<const Point> input) {
  const TetFacts facts = facts_of(mesh);
  EXPECT_GT(facts.least, 0);
  EXPECT_EQ(facts.bad_faces, 0u);
  ASSERT_EQ(mesh.merged_to.size(), input.size());
  Point low = mesh.points[0], high = low;
  for (const Point& p : mesh.points)
    for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]), high[i] = std::max(high[i], p[i]);
  const double box = (high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
  EXPECT_NEAR(facts.volume, box, 1e-9 * box);
  std::size_t repeated = 0;
  for (Index i = 0; i < input.size(); ++i) {
    EXPECT_EQ(mesh.points[i], input[i]);
    EXPECT_EQ(input[mesh.merged_to[i]], input[i]);
    repeated += mesh.merged_to[i] != i;
  }
  EXPECT_EQ(facts.unused_points, repeated);
  EXPECT_EQ(mesh.tets.vertices, mesh.points.size());
}

/// How far inside the circumscribed sphere of a tetrahedron a point is, relative to the radius.
long double depth(const DelaunayMesh& mesh, std::size_t t, const Point& p) {
  const auto c = mesh.tets.facet(t);
  long double m[3][4];
  for (std::size_t k = 0; k < 3; ++k) {
    m[k][3] = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      m[k][i] = static_cast<long double>(mesh.points[c[k + 1]][i]) - mesh.points[c[0]][i];
      m[k][3] += m[k][i] * m[k][i] / 2;
    }
  }
  const auto det = [&](std::size_t x, std::size_t y, std::size_t z) {
    return m[0][x] * (m[1][y] * m[2][z] - m[1][z] * m[2][y]) -
           m[0][y] * (m[1][x] * m[2][z] - m[1][z] * m[2][x]) +
           m[0][z] * (m[1][x] * m[2][y] - m[1][y] * m[2][x]);
  };
  const long double d = det(0, 1, 2), x = det(3, 1, 2) / d, y = det(0, 3, 2) / d, z = det(0, 1, 3) / d;
  const Point& a = mesh.points[c[0]];
  const long double radius = std::hypot(x, y, z);
  return (radius - std::hypot(p[0] - a[0] - x, p[1] - a[1] - y, p[2] - a[2] - z)) / radius;
}

}  // namespace

TEST(Delaunay, FillsTheBoxAndKeepsIndices) {
  for (const std::size_t count : {0u, 1u, 2u, 3u, 4u, 50u, 3000u}) {
    SCOPED_TRACE(count);
    const std::vector<Point> points = random_points(count, 7);
    const DelaunayMesh mesh = delaunay(points);
    EXPECT_EQ(mesh.points.size(), count + 8);
    expect_filled_box(mesh, points);
  }
}

TEST(Delaunay, NoPointIsInsideASphere) {
  const std::vector<Point> points = random_points(60, 3);
  const DelaunayMesh mesh = delaunay(points);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Point& p : mesh.points) EXPECT_LT(depth(mesh, t, p), 1e-9L);
}

TEST(Delaunay, TheBoxReachesBeyondThePointsByTheMargin) {
  const std::vector<Point> points{{0, 0, 0}, {3, 4, 0}};
  const DelaunayMesh mesh = delaunay(points, {.box_margin = 0.5});
  for (std::size_t i = 0; i < 3; ++i) {
    const double below = points[0][i] - mesh.points[2][i], above = mesh.points[9][i] - points[1][i];
    EXPECT_TRUE(below >= 2.5 && below <= 1.41 * 2.5 && above >= 2.5 && above <= 1.41 * 2.5) << i;
    EXPECT_NE(below, above);
  }
}

// TetGen ends the program if planes of the box and the grid pass through few points in special places.
TEST(Delaunay, PointsWithSmallIntegerCoordinates) {
  std::mt19937 random(1);
  for (int i = 0; i < 500; ++i) {
    std::vector<Point> points(4 + random() % 8);
    for (Point& p : points) p = {double(random() % 4), double(random() % 4), double(random() % 4)};
    expect_filled_box(delaunay(points, {.grid_spacing = i % 2 ? 0.0 : 1.0}), points);
  }
}

TEST(Delaunay, RepeatedPointsAreMergedToTheFirst) {
  std::vector<Point> points = random_points(40, 5);
  points.push_back(points[3]), points.push_back(points[3]), points.push_back(points[0]);
  points.push_back({0.0, 0.5, 0.5}), points.push_back({-0.0, 0.5, 0.5});
  const DelaunayMesh mesh = delaunay(points);
  EXPECT_EQ(mesh.merged_to[40], 3u);
  EXPECT_EQ(mesh.merged_to[41], 3u);
  EXPECT_EQ(mesh.merged_to[42], 0u);
  EXPECT_EQ(mesh.merged_to[44], 43u);
  EXPECT_EQ(facts_of(mesh).unused_points, 4u);
}

TEST(Delaunay, VeryClosePointsAreNotMerged) {
  std::vector<Point> points{{0, 0, 0}, {1, 1, 1}, {std::nextafter(1.0, 2.0), 1, 1}, {1e-14, 0, 0}};
  expect_filled_box(delaunay(points), points);
}

TEST(Delaunay, FlatAndDegenerateInputsAreFineInABox) {
  std::vector<Point> plane, line, lattice;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 8; ++j) {
      plane.push_back({1.0 * i, 1.0 * j, 0.0});
      line.push_back({0.1 * (8 * i + j), 0.2 * (8 * i + j), 0.3 * (8 * i + j)});
      for (int k = 0; k < 8; ++k) lattice.push_back({1.0 * i, 1.0 * j, 1.0 * k});
    }
  for (const auto* points : {&plane, &line, &lattice}) expect_filled_box(delaunay(*points), *points);
  expect_filled_box(delaunay(lattice, {.box_margin = 0}), lattice);
}

TEST(Delaunay, AGridFillsTheBoxAndKeepsAwayFromThePoints) {
  const std::vector<Point> points = random_points(200, 11);
  const double spacing = 0.15;
  const DelaunayOptions options{.box_margin = 0.2, .grid_spacing = spacing, .grid_clearance = 0.5};
  const DelaunayMesh mesh = delaunay(points, options);
  expect_filled_box(mesh, points);
  EXPECT_GT(mesh.points.size(), points.size() + 500);
  for (std::size_t a = points.size() + 1; a < mesh.points.size(); ++a) {
    const Point& q = mesh.points[a];
    for (const Point& p : points)
      EXPECT_GE(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), spacing / 2) << "added point " << a;
  }
  // The largest hole that grid and clearance can leave has about this edge length.
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const Index v : mesh.tets.facet(t)) {
      const Point &p = mesh.points[v], &q = mesh.points[mesh.tets.facet(t)[0]];
      EXPECT_LT(std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]), 4 * spacing);
    }
}

TEST(Delaunay, AGridKeepsAwayFromTriangles) {
  const std::vector<Point> points{{0, 0, 0}, {1, 0.1, 0.2}, {0.1, 1, 0.7}};
  DelaunayOptions options{.grid_spacing = 0.06};
  const std::size_t all = delaunay(points, options).points.size();
  options.triangles = {2, 3, {0, 1, 2}};
  const DelaunayMesh mesh = delaunay(points, options);
  expect_filled_box(mesh, points);
  EXPECT_LT(mesh.points.size() + 50, all);  // the area is that of more than 150 squares of the grid
  for (std::size_t i = 3; i < mesh.points.size(); ++i) {
    const Point& q = mesh.points[i];
    double least = 1;
    for (int a = 0; a <= 100; ++a)  // points of the triangle
      for (int b = 0; a + b <= 100; ++b) {
        double squared = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          const double x = (a * points[0][k] + b * points[1][k] + (100 - a - b) * points[2][k]) / 100;
          squared += (x - q[k]) * (x - q[k]);
        }
        least = std::min(least, squared);
      }
    EXPECT_GE(std::sqrt(least), 0.029) << i;
  }
}

TEST(Delaunay, IsTheSameAgainAndForAnyScale) {
  const std::vector<Point> points = random_points(300, 2);
  const DelaunayMesh mesh = delaunay(points);
  EXPECT_EQ(delaunay(points).tets.corners, mesh.tets.corners);
  for (const double scale : {1e-30, 1e-6, 1e6, 1e30})
    expect_filled_box(delaunay(random_points(300, 2, scale)), random_points(300, 2, scale));
}

TEST(Delaunay, RefusesWhatTetGenWouldAbortOn) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  std::vector<Point> points = random_points(10, 1);
  points[6][1] = nan;
  try {
    delaunay(points);
    FAIL() << "a point that is not a number was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("point 6"), std::string::npos) << error.what();
  }
  points[6][1] = infinity;
  EXPECT_THROW(delaunay(points), InputError);
  const std::vector<Point> plane{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  EXPECT_THROW(delaunay(plane, {.box_margin = 0}), InputError);
  EXPECT_THROW(delaunay(random_points(10, 1, 1e60)), InputError);
  EXPECT_THROW(delaunay(random_points(10, 1, 1e-60)), InputError);
  EXPECT_THROW(delaunay(plane, {.grid_spacing = 1e-9}), InputError);
  const std::vector<Point> far{{1e20, 0, 0}, {1e20, 1, 1}};
  EXPECT_THROW(delaunay(far), InputError);
}

TEST(Delaunay, RefusesOptionsOutOfRange) {
  EXPECT_THROW(delaunay({}, {.box_margin = -1}), UsageError);
  EXPECT_THROW(delaunay({}, {.box_margin = std::nan("")}), UsageError);
  EXPECT_THROW(delaunay({}, {.grid_spacing = -1}), UsageError);
  EXPECT_THROW(delaunay({}, {.grid_clearance = 2}), UsageError);
}

TEST(Delaunay, FourThreadsAtOnceGetWhatOneGets) {
  std::vector<std::vector<Index>> alone, together(4);
  for (unsigned i = 0; i < 4; ++i) alone.push_back(delaunay(random_points(2000, i, i + 1)).tets.corners);
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < 4; ++i)
      threads.emplace_back([&, i] {
        for (int again = 0; again < 3; ++again)
          together[i] = delaunay(random_points(2000, i, i + 1)).tets.corners;
      });
  }
  for (unsigned i = 0; i < 4; ++i) EXPECT_EQ(together[i], alone[i]);
}

}  // namespace multimesh::test
