// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "multimesh/tetgen/tetrahedralize.hpp"
#include "test/tetgen/closed_shapes.hpp"
#include "test/tetgen/tet_facts.hpp"

namespace multimesh::test {

using tetgen::Keep;
using tetgen::Tetrahedralization;
using tetgen::tetrahedralize;
using tetgen::TetrahedralizeOptions;

namespace {

Tetrahedralization fill(const ClosedSurface& surface, const TetrahedralizeOptions& options = {}) {
  Tetrahedralization mesh = tetrahedralize(surface.points, surface.triangles, options);
  const TetFacts facts = facts_of(mesh);
  EXPECT_GT(facts.least, 0);
  EXPECT_EQ(facts.bad_faces, 0u);
  EXPECT_NEAR(facts.volume, mesh.volume, 1e-12 * mesh.volume);
  EXPECT_EQ(mesh.tets.size(), mesh.region.size());
  EXPECT_TRUE(std::equal(surface.points.begin(), surface.points.end(), mesh.points.begin()));
  EXPECT_TRUE(std::is_sorted(mesh.faces.begin(), mesh.faces.end(),
                             [](const auto& a, const auto& b) { return a.triangle < b.triangle; }));
  return mesh;
}

/// That each triangle is the face that says so, turned round at most.
void expect_triangles_as_faces(const ClosedSurface& surface, const Tetrahedralization& mesh) {
  ASSERT_EQ(mesh.faces.size(), surface.triangles.size());
  for (Index t = 0; t < mesh.faces.size(); ++t) {
    EXPECT_EQ(mesh.faces[t].triangle, t);
    std::array<Index, 3> own{}, face = mesh.faces[t].corners;
    std::copy_n(surface.triangles.facet(t).begin(), 3, own.begin());
    std::rotate(own.begin(), std::min_element(own.begin(), own.end()), own.end());
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    EXPECT_EQ(own, face);
  }
}

ClosedSurface nested(bool inner_reversed) {
  const ClosedSurface inner = sphere(1, 2);
  return joined(sphere(2, 3), inner_reversed ? reversed(inner) : inner);
}

}  // namespace

TEST(Tetrahedralize, FillsSmallShapesWithTheirTrianglesAsFaces) {
  for (const ClosedSurface& surface :
       {cube(), cube(1e-9), cube(1e9), sphere(1, 3), torus(2, 0.5, 30, 12), reversed(cube())}) {
    const Tetrahedralization mesh = fill(surface);
    EXPECT_EQ(facts_of(mesh).border_faces, surface.triangles.size());
    EXPECT_EQ(mesh.winding.size(), 1u);
    EXPECT_EQ(facts_of(mesh).unused_points, 0u);
    expect_triangles_as_faces(surface, mesh);
  }
  EXPECT_NEAR(fill(cube(2)).volume, 8, 1e-12);
  EXPECT_EQ(fill(cube()).winding, std::vector<int>{1});
  EXPECT_EQ(fill(reversed(cube())).winding, std::vector<int>{-1});
}

TEST(Tetrahedralize, ACavityIsAHoleWhenItIsOrientedSo) {
  const ClosedSurface surface = nested(true);
  const Tetrahedralization shell = fill(surface), both = fill(surface, {.keep = Keep::all});
  EXPECT_EQ(shell.winding, std::vector<int>{1});
  EXPECT_EQ(facts_of(shell).border_faces, surface.triangles.size());
  EXPECT_NEAR(shell.volume, fill(sphere(2, 3)).volume - fill(sphere(1, 2)).volume, 1e-9);
  expect_triangles_as_faces(surface, shell);
  EXPECT_EQ(std::set<int>(both.winding.begin(), both.winding.end()), (std::set<int>{0, 1}));
  EXPECT_NEAR(both.volume, fill(sphere(2, 3)).volume, 1e-9);
  EXPECT_EQ(facts_of(both).border_faces, sphere(2, 3).triangles.size());
}

TEST(Tetrahedralize, InnerSurfacesAreInterfacesOrHolesByTheRule) {
  const ClosedSurface surface = nested(false);
  const Tetrahedralization winding = fill(surface), odd = fill(surface, {.keep = Keep::even_odd});
  EXPECT_EQ(std::set<int>(winding.winding.begin(), winding.winding.end()), (std::set<int>{1, 2}));
  EXPECT_EQ(facts_of(winding).border_faces, sphere(2, 3).triangles.size());
  expect_triangles_as_faces(surface, winding);
  EXPECT_EQ(odd.winding, std::vector<int>{1});
  EXPECT_EQ(facts_of(odd).border_faces, surface.triangles.size());
  double inner = 0;
  for (std::size_t t = 0; t < winding.tets.size(); ++t) inner += winding.winding[winding.region[t]] == 2;
  EXPECT_GT(inner, 0);
}

TEST(Tetrahedralize, SeparateAndPinchedPartsAreRegions) {
  ClosedSurface apart = joined(sphere(1, 1), sphere(1, 1, {3, 0, 0}));
  EXPECT_EQ(fill(apart).winding, (std::vector<int>{1, 1}));
  // Two tetrahedra that share a point.
  ClosedSurface pinched;
  pinched.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
  pinched.triangles.corners = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2, 0, 4, 5, 0, 6, 4, 4, 6, 5, 0, 5, 6};
  pinched.triangles.vertices = 7;
  EXPECT_EQ(fill(pinched).winding.size(), 2u);
}

TEST(Tetrahedralize, PointsThatNoTriangleUsesStayUnused) {
  ClosedSurface surface = cube();
  surface.points.insert(surface.points.begin() + 3, {5, 5, 5});
  for (Index& v : surface.triangles.corners) v += v >= 3;
  ++surface.triangles.vertices;
  const Tetrahedralization mesh = fill(surface, {.max_volume = 0.01});
  EXPECT_EQ(facts_of(mesh).unused_points, 1u);
  EXPECT_GT(mesh.points.size(), 9u);
  expect_triangles_as_faces(surface, mesh);
}

TEST(Tetrahedralize, KeepsVolumesBelowTheBound) {
  const double edge = 0.3, regular = edge * edge * edge / (6 * std::sqrt(2.0));
  for (const bool split : {false, true}) {
    const ClosedSurface surface = sphere(1, split ? 2 : 4);
    const Tetrahedralization by_volume = fill(surface, {.max_volume = 0.01, .split_surface = split});
    EXPECT_LE(facts_of(by_volume).most, 0.01 * (1 + 1e-9));
    const Tetrahedralization by_edge = fill(surface, {.edge_length = edge, .split_surface = split});
    EXPECT_LE(facts_of(by_edge).most, regular * (1 + 1e-9));
    EXPECT_GT(by_edge.tets.size(), by_volume.tets.size());
    if (!split) expect_triangles_as_faces(surface, by_edge);
  }
}

TEST(Tetrahedralize, SplitsTheSurfaceOnlyWhenAskedTo) {
  const ClosedSurface surface = cube();
  const TetrahedralizeOptions fine{.max_volume = 0.001, .radius_edge_ratio = 1.4, .min_dihedral = 10};
  expect_triangles_as_faces(surface, fill(surface, fine));
  TetrahedralizeOptions split = fine;
  split.split_surface = true;
  const Tetrahedralization mesh = fill(surface, split);
  EXPECT_GT(mesh.faces.size(), surface.triangles.size());
  EXPECT_NEAR(mesh.volume, 1, 1e-9);
  EXPECT_EQ(facts_of(mesh).border_faces, mesh.faces.size());
  std::vector<double> area(12);
  for (const auto& face : mesh.faces) {
    const auto &a = mesh.points[face.corners[0]], &b = mesh.points[face.corners[1]],
               &c = mesh.points[face.corners[2]];
    const double u[3]{b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3]{c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    area[face.triangle] +=
        std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
  }
  for (const double a : area) EXPECT_NEAR(a, 0.5, 1e-9);
}

TEST(Tetrahedralize, IsTheSameAgain) {
  const Tetrahedralization a = fill(torus(2, 0.5, 20, 8), {.max_volume = 0.01}),
                           b = fill(torus(2, 0.5, 20, 8), {.max_volume = 0.01});
  EXPECT_EQ(a.tets.corners, b.tets.corners);
  EXPECT_EQ(a.points, b.points);
}

}  // namespace multimesh::test
