// SPDX-License-Identifier: BSD-3-Clause
// Several materials, listed as in files: the enclosed regions are found a second time by filling voxels.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "multimesh/error.hpp"
#include "multimesh/tetgen/tetrahedralize.hpp"
#include "test/tetgen/closed_shapes.hpp"
#include "test/tetgen/tet_facts.hpp"
#include "test/tetgen/voxels.hpp"

namespace multimesh::test {

using tetgen::Point;
using tetgen::Tetrahedralization;

namespace {

constexpr double voxel_volume = 0.5 * 0.25;

std::array<Index, 3> sorted(std::array<Index, 3> c) {
  std::sort(c.begin(), c.end());
  return c;
}

std::set<std::array<Index, 3>> triangles_of(const Voxels::Surface& surface) {
  std::set<std::array<Index, 3>> all;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto c = surface.triangles.facet(t);
    all.insert(sorted({c[0], c[1], c[2]}));
  }
  return all;
}

Point middle(const Tetrahedralization& mesh, std::size_t tet) {
  Point p{};
  for (const Index v : mesh.tets.facet(tet))
    for (std::size_t i = 0; i < 3; ++i) p[i] += mesh.points[v][i] / 4;
  return p;
}

/// That regions are the parts of the voxels which must be filled, with their volumes.
void expect_regions(const Tetrahedralization& mesh, const Voxels& voxels, bool is_empty_filled) {
  const std::vector<int> parts = voxels.parts();
  std::map<int, double> expected, volume;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i) {
    const int n = voxels.size();
    const bool is_empty = voxels.material({i % n, i / n % n, i / n / n}) == 0;
    const int part = parts[static_cast<std::size_t>(i)];
    if (part != 0 && (is_empty_filled || !is_empty)) expected[part] += voxel_volume;
  }
  ASSERT_EQ(mesh.winding.size(), expected.size());
  std::map<Index, int> part_of;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const int i = voxels.index(voxels.voxel_at(middle(mesh, t)));
    ASSERT_GE(i, 0);
    const int part = parts[static_cast<std::size_t>(i)];
    ASSERT_EQ(part_of.try_emplace(mesh.region[t], part).first->second, part) << "a region of two parts";
    const auto c = mesh.tets.facet(t);
    TetFacts one = facts_of({mesh.points, {3, mesh.tets.vertices, {c.begin(), c.end()}}});
    volume[part] += one.volume;
  }
  EXPECT_EQ(part_of.size(), expected.size());
  ASSERT_EQ(volume.size(), expected.size());
  for (const auto& [part, v] : expected) EXPECT_NEAR(volume[part], v, 1e-9 * v);
}

/// That each triangle with something on a side is a face, once, and no other face is on the surface.
void expect_faces(const Tetrahedralization& mesh, const std::set<std::array<Index, 3>>& triangles) {
  std::set<std::array<Index, 3>> faces, of_tets;
  for (const auto& face : mesh.faces) EXPECT_TRUE(faces.insert(sorted(face.corners)).second);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    for (const auto& f : tetgen::outward_faces)
      of_tets.insert(sorted({mesh.tets.facet(t)[f[0]], mesh.tets.facet(t)[f[1]], mesh.tets.facet(t)[f[2]]}));
  EXPECT_EQ(faces, triangles);
  for (const auto& face : faces) EXPECT_TRUE(of_tets.contains(face));
  for (const auto& face : mesh.faces)
    EXPECT_FALSE(face.regions.behind == no_index && face.regions.before == no_index);
}

Tetrahedralization fill(const Voxels::Surface& surface, const tetgen::TetrahedralizeOptions& options = {}) {
  Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles, options);
  const TetFacts facts = facts_of(mesh);
  EXPECT_GT(facts.least, 0);
  EXPECT_EQ(facts.bad_faces, 0u);
  return mesh;
}

bool has_warning(const Tetrahedralization& mesh, const std::string& part) {
  return std::any_of(mesh.warnings.begin(), mesh.warnings.end(),
                     [&](const std::string& w) { return w.find(part) != std::string::npos; });
}

}  // namespace

TEST(Complexes, RandomVoxelsAreRegionsHoweverTheyAreListed) {
  for (unsigned seed = 0; seed < 24; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const int size = 3 + static_cast<int>(seed % 3);
    Voxels voxels = Voxels::random(size, 1 + static_cast<int>(seed % 4), 0.5 + 0.02 * seed, random);
    if (seed % 2 == 1) voxels.add_walls(0.15, random);
    for (const Listing listing : {Listing::once, Listing::twice, Listing::by_solid}) {
      const Voxels::Surface surface = voxels.surface(listing, random);
      const Tetrahedralization mesh = fill(surface);
      expect_regions(mesh, voxels, listing == Listing::once);
      expect_faces(mesh, triangles_of(surface));
      if (seed % 6 == 0) {
        const Tetrahedralization fine = fill(surface, {.max_volume = 0.01});
        expect_regions(fine, voxels, listing == Listing::once);
        expect_faces(fine, triangles_of(surface));
      }
    }
  }
}

TEST(Complexes, ShellsInShellsAreRegionsOrCavities) {
  // From outside to inside: 1, 2, empty, 3, 1; each with all squares to the next.
  constexpr int size = 9, materials[]{1, 2, 0, 3, 1};
  std::vector<int> all;
  for (int i = 0; i < size * size * size; ++i) {
    int depth = size;
    for (const int x : {i % size, i / size % size, i / size / size})
      depth = std::min({depth, x, size - 1 - x});
    all.push_back(materials[depth]);
  }
  const Voxels voxels(size, all);
  std::mt19937 random(1);
  for (const Listing listing : {Listing::once, Listing::twice, Listing::by_solid}) {
    const Voxels::Surface surface = voxels.surface(listing, random);
    const Tetrahedralization mesh = fill(surface);
    expect_regions(mesh, voxels, listing == Listing::once);
    expect_faces(mesh, triangles_of(surface));
    EXPECT_EQ(mesh.winding.size(), listing == Listing::once ? 5u : 4u);
    EXPECT_EQ(has_warning(mesh, "does not tell what is empty"), listing == Listing::once);
    const Tetrahedralization full =
        tetgen::tetrahedralize(surface.points, surface.triangles, {.keep = tetgen::Keep::all});
    EXPECT_EQ(full.winding.size(), 5u);
    EXPECT_NEAR(full.volume, size * size * size * voxel_volume, 1e-9);
  }
}

TEST(Complexes, RegionsAreNumberedByTheTrianglesAlone) {
  std::mt19937 random(5);
  const Voxels voxels = Voxels::random(4, 3, 0.8, random);
  const Voxels::Surface surface = voxels.surface(Listing::by_solid, random);
  const Tetrahedralization coarse = fill(surface), fine = fill(surface, {.max_volume = 0.01});
  const std::vector<int> parts = voxels.parts();
  const auto order = [&](const Tetrahedralization& mesh) {
    std::map<Index, int> part;
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
      part[mesh.region[t]] = parts[static_cast<std::size_t>(voxels.index(voxels.voxel_at(middle(mesh, t))))];
    return part;
  };
  EXPECT_EQ(order(coarse), order(fine));
}

TEST(Complexes, SheetsStayAndWhatHangsOutsideIsLeftOutWithAWarning) {
  // One block of material with a sheet inside, one that hangs on its border, and a fin outside.
  std::vector<int> materials(27, 0);
  for (int i = 0; i < 9; ++i) materials[static_cast<std::size_t>(i)] = 1;
  for (int i = 9; i < 18; ++i) materials[static_cast<std::size_t>(i)] = 1;
  Voxels voxels(3, materials);
  voxels.add_wall({1, 1, 0}, 2);  // inside, its border free
  voxels.add_wall({0, 0, 0}, 0);  // at the border
  const auto inside = [&] {
    std::mt19937 random(1);
    return triangles_of(voxels.surface(Listing::twice, random));
  }();
  voxels.add_wall({1, 1, 2}, 0);  // outside, on the block
  std::mt19937 random(1);
  const Voxels::Surface surface = voxels.surface(Listing::twice, random);
  const Tetrahedralization mesh = fill(surface);
  EXPECT_EQ(mesh.winding.size(), 1u);
  EXPECT_NEAR(mesh.volume, 18 * voxel_volume, 1e-9);
  std::set<std::array<Index, 3>> faces;
  for (const auto& face : mesh.faces) faces.insert(sorted(face.corners));
  EXPECT_EQ(faces.size(), inside.size());
  EXPECT_EQ(triangles_of(surface).size(), inside.size() + 2);
  EXPECT_TRUE(has_warning(mesh, "2 triangles bound nothing that is filled"));
  EXPECT_TRUE(has_warning(mesh, "4 triangles separate nothing"));
  const Tetrahedralization fine = fill(surface, {.max_volume = 0.01});
  EXPECT_EQ(fine.faces.size(), inside.size());
}

TEST(Complexes, SeedsNameRegionsAndMakeHoles) {
  // Two voxels of different materials, side by side.
  const Voxels voxels(2, {1, 2, 0, 0, 0, 0, 0, 0});
  std::mt19937 random(1);
  const Voxels::Surface surface = voxels.surface(Listing::once, random);
  const Point left{0.25, 0.1, 0.5}, right{0.75, 0.1, 0.5};
  const Tetrahedralization both = fill(surface, {.regions = {{"oil", right}, {"water", left}}});
  ASSERT_EQ(both.names.size(), 2u);
  for (std::size_t t = 0; t < both.tets.size(); ++t)
    EXPECT_EQ(both.names[both.region[t]], middle(both, t)[0] < 0.5 ? "water" : "oil");
  for (const double max_volume : {0.0, 0.01}) {
    const Tetrahedralization one =
        fill(surface, {.regions = {{"water", left}}, .holes = {right}, .max_volume = max_volume});
    EXPECT_EQ(one.names, std::vector<std::string>{"water"});
    EXPECT_NEAR(one.volume, voxel_volume, 1e-12);
    EXPECT_EQ(one.faces.size(), 12u);
    EXPECT_TRUE(has_warning(one, "10 triangles bound nothing"));
  }
  const auto refused = [&](const tetgen::TetrahedralizeOptions& options, const std::string& word) {
    try {
      fill(surface, options);
      ADD_FAILURE() << word;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    }
  };
  refused({.regions = {{"air", {5, 5, 5}}}}, "seed of region air at (5, 5, 5) is in no region");
  refused({.holes = {{0.5, 0.1, 0.5}}}, "between two regions");
  refused({.regions = {{"a", left}, {"b", left}}}, "regions a and b are in the same region");
  refused({.regions = {{"a", left}}, .holes = {left}}, "is in region a");
  refused({.holes = {left, right}}, "no region is left");
}

TEST(Complexes, ASeedFillsACavity) {
  const ClosedSurface surface = joined(sphere(2, 2), reversed(sphere(1, 1)));
  const Tetrahedralization empty = tetgen::tetrahedralize(surface.points, surface.triangles),
                           filled = tetgen::tetrahedralize(surface.points, surface.triangles,
                                                           {.regions = {{"core", {0, 0, 0}}}});
  EXPECT_EQ(empty.winding.size(), 1u);
  EXPECT_EQ(filled.winding.size(), 2u);
  EXPECT_EQ(std::count(filled.names.begin(), filled.names.end(), "core"), 1);
}

TEST(Complexes, AFewTurnedTrianglesDoNotFillACavity) {
  ClosedSurface surface = joined(sphere(2, 2), reversed(sphere(1, 2)));
  const auto turn = [&](std::size_t t) {
    std::swap(surface.triangles.corners[3 * t], surface.triangles.corners[3 * t + 1]);
  };
  for (const std::size_t t : {3, 77, 130, 200}) turn(t);
  const Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
  EXPECT_EQ(mesh.winding, std::vector<int>{1});
  EXPECT_TRUE(has_warning(mesh, "4 triangles run against the others"));
  for (std::size_t t = 128; t < 256; t += 2) turn(t);
  const Tetrahedralization mixed = tetgen::tetrahedralize(surface.points, surface.triangles);
  EXPECT_EQ(mixed.winding.size(), 2u) << "now nothing tells that it is one";
  EXPECT_TRUE(has_warning(mixed, "does not tell what is empty"));
}

TEST(Complexes, AnyOrientationOfOneShellIsFilled) {
  std::mt19937 random(3);
  ClosedSurface surface = torus(2, 0.5, 20, 8);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    if (random() % 2 == 0) std::swap(surface.triangles.corners[3 * t], surface.triangles.corners[3 * t + 1]);
  const Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
  EXPECT_EQ(mesh.winding.size(), 1u);
  EXPECT_EQ(mesh.faces.size(), surface.triangles.size());
}

TEST(Complexes, RepeatedTrianglesAreLeftOutWithAWarning) {
  ClosedSurface surface = sphere(1, 1);
  auto& corners = surface.triangles.corners;
  corners.insert(corners.end(), {corners[3], corners[4], corners[5]});  // once more
  corners.insert(corners.end(), {corners[7], corners[6], corners[8]});  // and turned round
  const Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
  EXPECT_EQ(mesh.faces.size(), surface.triangles.size() - 2);
  EXPECT_TRUE(has_warning(mesh, "2 triangles with the corners of another one left out"));
  // All of them, both ways round.
  ClosedSurface doubled = sphere(1, 2);
  const ClosedSurface back = reversed(doubled);
  doubled.triangles.corners.insert(doubled.triangles.corners.end(), back.triangles.corners.begin(),
                                   back.triangles.corners.end());
  EXPECT_EQ(tetgen::tetrahedralize(doubled.points, doubled.triangles).winding.size(), 1u);
}

}  // namespace multimesh::test
