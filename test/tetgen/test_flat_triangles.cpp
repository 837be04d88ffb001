// SPDX-License-Identifier: BSD-3-Clause
// Triangles without area, whose neighbours do not meet in whole edges after they are removed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "multimesh/tetgen/facets.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"
#include "test/tetgen/closed_shapes.hpp"
#include "test/tetgen/tet_facts.hpp"

namespace multimesh::test {

using tetgen::Point;

namespace {

using Edge = std::array<Index, 2>;

/// Replaces the edge a-b of one of its two triangles by the points that are given, with flat triangles in
/// between, as tools leave them that close T-junctions; the other triangle is split at the points.
void add_flat_triangles(ClosedSurface& surface, std::size_t triangle, std::size_t corner, int points,
                        std::mt19937& random) {
  auto& corners = surface.triangles.corners;
  const Index a = corners[3 * triangle + corner], b = corners[3 * triangle + (corner + 1) % 3];
  std::size_t other = 0, k = 0;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      if (corners[3 * t + i] == b && corners[3 * t + (i + 1) % 3] == a) other = t, k = i;
  const Index apex = corners[3 * other + (k + 2) % 3];
  // From b to a; with steps of a power of two, all are exactly on the edge.
  std::vector<Index> chain{b};
  for (int i = 1; i <= points; ++i) {
    Point p{};
    for (std::size_t j = 0; j < 3; ++j)
      p[j] = surface.points[b][j] + (surface.points[a][j] - surface.points[b][j]) * i / 8;
    chain.push_back(static_cast<Index>(surface.points.size()));
    surface.points.push_back(p);
  }
  chain.push_back(a);
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) {
    const std::array<Index, 3> part{chain[i], chain[i + 1], apex};
    if (i == 0)
      std::copy(part.begin(), part.end(), corners.begin() + static_cast<std::ptrdiff_t>(3 * other));
    else
      corners.insert(corners.end(), part.begin(), part.end());
  }
  // The polygon of the chain, all on one line, in any triangulation.
  while (chain.size() > 2) {
    const std::size_t i = 1 + random() % (chain.size() - 2);
    corners.insert(corners.end(), {chain[i - 1], chain[i + 1], chain[i]});
    chain.erase(chain.begin() + static_cast<std::ptrdiff_t>(i));
  }
  surface.triangles.vertices = static_cast<Index>(surface.points.size());
}

/// Edges with an odd number of triangles.
std::set<Edge> odd_edges(const tetgen::Facets& facets) {
  std::set<Edge> odd;
  for (Index f = 0; f < facets.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto c = facets.facet(f);
      const Edge e{std::min(c[k], c[(k + 1) % 3]), std::max(c[k], c[(k + 1) % 3])};
      if (!odd.insert(e).second) odd.erase(e);
    }
  return odd;
}

}  // namespace

TEST(FlatTriangles, AreLeftOutAndTheirNeighboursMeetInWholeEdges) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    ClosedSurface surface = cube(8);
    std::set<Edge> done;
    std::size_t flat = 0;
    for (int i = 0; i < 6; ++i) {
      const std::size_t t = random() % 12, corner = random() % 3;
      const Index a = surface.triangles.corners[3 * t + corner],
                  b = surface.triangles.corners[3 * t + (corner + 1) % 3];
      if (a > 7 || b > 7 || !done.insert({std::min(a, b), std::max(a, b)}).second) continue;
      const int points = 1 + static_cast<int>(random() % 5);
      add_flat_triangles(surface, t, corner, points, random);
      flat += static_cast<std::size_t>(points);
    }
    const tetgen::Facets facets = tetgen::make_facets(surface.points, surface.triangles);
    EXPECT_EQ(facets.flat, flat);
    EXPECT_EQ(odd_edges(facets), std::set<Edge>{});
    const tetgen::Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
    EXPECT_NEAR(facts_of(mesh).volume, 512, 1e-9);
    EXPECT_EQ(facts_of(mesh).bad_faces, 0u);
    EXPECT_EQ(facts_of(mesh).unused_points, 0u) << "points of the surface are kept";
    EXPECT_EQ(mesh.winding, std::vector<int>{1});
    EXPECT_NE(mesh.warnings.at(0).find(std::to_string(flat) + " triangle"), std::string::npos);
  }
}

TEST(FlatTriangles, OnesThatRoundingHasGivenAnAreaAreRepaired) {
  std::size_t repaired = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    ClosedSurface surface = cube(8);
    add_flat_triangles(surface, random() % 12, random() % 3, 1 + static_cast<int>(random() % 3), random);
    std::uniform_real_distribution<double> angle(0, 6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double c = std::cos(angle(random)), s = std::sqrt(1 - c * c);
      for (Point& p : surface.points) {
        const double x = p[axis], y = p[(axis + 1) % 3];
        p[axis] = c * x - s * y, p[(axis + 1) % 3] = s * x + c * y;
      }
    }
    if (seed % 2 == 0)  // as an STL file has it
      for (Point& p : surface.points)
        for (double& x : p) x = static_cast<double>(static_cast<float>(x));
    const tetgen::Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
    EXPECT_NEAR(facts_of(mesh).volume, 512, 1e-3);
    EXPECT_EQ(facts_of(mesh).bad_faces, 0u);
    repaired += mesh.facets.flat > 0;
    if (seed % 2 == 1) {
      EXPECT_GT(mesh.facets.flat, 0u) << "doubles are not left to TetGen";
    }
    for (const std::string& w : mesh.warnings) EXPECT_NE(w.find("without area"), std::string::npos) << w;
  }
  EXPECT_GT(repaired, 5u) << "TetGen takes some as they are";
}

TEST(FlatTriangles, OnesThatNothingElseUsesAreDropped) {
  ClosedSurface surface = cube(2);
  surface.points.insert(surface.points.end(), {{1, 0, 0}, {1, 1, 0}});
  surface.triangles.corners.insert(surface.triangles.corners.end(), {0, 1, 8});
  surface.triangles.corners.insert(surface.triangles.corners.end(), {0, 0, 1});
  surface.triangles.vertices = 10;
  const tetgen::Facets facets = tetgen::make_facets(surface.points, surface.triangles);
  EXPECT_EQ(facets.size(), 12u);
  EXPECT_EQ(facets.flat, 1u);
  EXPECT_EQ(facets.split, 0u);
  EXPECT_EQ(facets.collapsed, 1u);
}

}  // namespace multimesh::test
