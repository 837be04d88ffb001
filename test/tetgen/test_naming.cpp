// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "adapters/tetgen/missed_bounds.hpp"
#include "adapters/tetgen/naming.hpp"
#include "test/tetgen/closed_shapes.hpp"
#include "test/tetgen/voxels.hpp"

namespace multimesh::test {

using tetgen::Naming;
using tetgen::Tetrahedralization;
using tetgen::TriangleNames;

namespace {

TriangleNames names_of(const Voxels::Surface& surface) {
  TriangleNames names;
  for (const int m : surface.material) {
    names.tags.push_back(m);
    if (m != 0) names.parts[m] = {"m" + std::to_string(m)};
  }
  return names;
}

Voxels row(std::vector<int> materials) {
  const auto n = static_cast<int>(materials.size());
  materials.resize(static_cast<std::size_t>(n * n * n), 0);
  return {n, std::move(materials)};
}

/// The names of regions along the x axis, one per voxel of the first row.
std::vector<std::string> names_along(const Tetrahedralization& mesh, const Naming& naming, int n) {
  std::vector<std::string> names(static_cast<std::size_t>(n));
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    double x = 0;
    for (const Index v : mesh.tets.facet(t)) x += mesh.points[v][0] / 4;
    names[static_cast<std::size_t>(x / 0.5)] = naming.regions[mesh.region[t]].name;
  }
  return names;
}

std::vector<std::string> patch_names(const Naming& naming) {
  std::vector<std::string> names;
  for (const auto& p : naming.patches) names.push_back(p.name);
  return names;
}

}  // namespace

TEST(Naming, RegionsHaveTheNamesOfTheSolidsThatListThem) {
  for (unsigned seed = 0; seed < 16; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Voxels voxels = Voxels::random(4, 1 + static_cast<int>(seed % 4), 0.6, random);
    const Voxels::Surface surface = voxels.surface(Listing::by_solid, random);
    const Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
    const Naming naming = tetgen::name_parts(mesh, names_of(surface));
    std::set<std::int32_t> tags;
    for (const auto& r : naming.regions) tags.insert(r.tag);
    EXPECT_EQ(tags.size(), naming.regions.size());
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
      tetgen::Point p{};
      for (const Index v : mesh.tets.facet(t))
        for (std::size_t i = 0; i < 3; ++i) p[i] += mesh.points[v][i] / 4;
      const std::string name = naming.regions[mesh.region[t]].name,
                        expected = "m" + std::to_string(voxels.material(voxels.voxel_at(p)));
      EXPECT_EQ(name.substr(0, name.find('.')), expected);
    }
    // A patch has the same parts and the same two regions everywhere, and no two patches have.
    std::map<std::int32_t, std::set<std::array<Index, 2>>> regions;
    std::map<std::array<Index, 2>, std::int32_t> tag_at;
    for (std::size_t i = 0; i < mesh.faces.size(); ++i) {
      const auto& r = mesh.faces[i].regions;
      const std::array<Index, 2> sides{std::min(r.behind, r.before), std::max(r.behind, r.before)};
      EXPECT_GT(naming.face_tags[i], 0);
      regions[naming.face_tags[i]].insert(sides);
      EXPECT_EQ(tag_at.try_emplace(sides, naming.face_tags[i]).first->second, naming.face_tags[i]);
    }
    EXPECT_EQ(regions.size(), naming.patches.size());
    for (const auto& [tag, sides] : regions) EXPECT_EQ(sides.size(), 1u);
  }
}

TEST(Naming, AnInterfaceListedForOneSideNamesBothRegions) {
  std::mt19937 random(1);
  const Voxels voxels = row({1, 2, 3});
  const Voxels::Surface surface = voxels.surface(Listing::once, random);
  const Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
  const Naming naming = tetgen::name_parts(mesh, names_of(surface));
  EXPECT_EQ(names_along(mesh, naming, 3), (std::vector<std::string>{"m1", "m2", "m3"}));
  EXPECT_EQ(patch_names(naming),
            (std::vector<std::string>{"m3", "m1:m1|outside", "m2:m2|outside", "m1:m1|m2", "m2:m2|m3"}));
  EXPECT_EQ(naming.patches[0].tag, 3) << "is all that has the tag";
  ASSERT_EQ(naming.warnings.size(), 1u);
  EXPECT_EQ(naming.warnings[0].substr(0, 27), "2 parts of the surface, m1 ");
}

TEST(Naming, InterfacesListedForEitherSideAtRandomNameTheirRegions) {
  // Between materials 1 and 2 there are several squares; each is listed by one of them.
  std::mt19937 random(1);
  const Voxels voxels(2, {1, 2, 2, 2, 1, 1, 1, 2});
  Voxels::Surface surface = voxels.surface(Listing::once, random);
  const Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
  const Naming naming = tetgen::name_parts(mesh, names_of(surface));
  ASSERT_EQ(naming.regions.size(), 2u);
  EXPECT_EQ((std::set<std::string>{naming.regions[0].name, naming.regions[1].name}),
            (std::set<std::string>{"m1", "m2"}));
}

TEST(Naming, AGroupOfPatchesNamesNoRegion) {
  const ClosedSurface surface = cube();
  const Tetrahedralization mesh = tetgen::tetrahedralize(surface.points, surface.triangles);
  TriangleNames names{{1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2}, {{1, {"inlet"}}, {2, {"wall"}}}};
  const Naming naming = tetgen::name_parts(mesh, names);
  EXPECT_EQ(naming.regions[0].name, "");
  EXPECT_EQ(naming.regions[0].tag, 1);
  EXPECT_EQ(patch_names(naming), (std::vector<std::string>{"inlet", "wall"}));
  for (std::size_t i = 0; i < mesh.faces.size(); ++i)
    EXPECT_EQ(naming.face_tags[i], names.tags[mesh.faces[i].triangle]);
  for (auto& [tag, part] : names.parts) part.object = "pipe";
  EXPECT_EQ(tetgen::name_parts(mesh, names).regions[0].name, "pipe");
  names.name_regions = false;
  EXPECT_EQ(tetgen::name_parts(mesh, names).regions[0].name, "");
}

TEST(Naming, SeedsGiveNamesAndNumbers) {
  std::mt19937 random(1);
  const Voxels voxels = row({1, 2, 3});
  const Voxels::Surface surface = voxels.surface(Listing::by_solid, random);
  const tetgen::Point a{0.25, 0.1, 0.5}, b{0.75, 0.1, 0.5}, c{1.25, 0.1, 0.5};
  const auto named = [&](std::vector<tetgen::RegionSeed> seeds) {
    const Tetrahedralization mesh =
        tetgen::tetrahedralize(surface.points, surface.triangles, {.regions = std::move(seeds)});
    return tetgen::name_parts(mesh, names_of(surface)).regions;
  };
  const auto numbered = named({{"2", a}, {"steel", b}});
  EXPECT_EQ(numbered[0].tag, 2);
  EXPECT_EQ(numbered[0].name, "");
  EXPECT_EQ(numbered[1].tag, 1);
  EXPECT_EQ(numbered[1].name, "steel");
  EXPECT_EQ(numbered[2].tag, 3);
  EXPECT_EQ(numbered[2].name, "m3");
  const auto one = named({{"steel", a}, {"steel", c}});
  EXPECT_EQ(one[0].tag, one[2].tag);
  EXPECT_NE(one[0].tag, one[1].tag);
}

std::vector<std::string> missed_by(const Tetrahedralization& mesh,
                                   const tetgen::TetrahedralizeOptions& options) {
  FacetList surface{2, static_cast<Index>(mesh.points.size()), {}};
  for (const tetgen::SurfaceFace& f : mesh.faces)
    surface.corners.insert(surface.corners.end(), f.corners.begin(), f.corners.end());
  return tetgen::missed_bounds(mesh, surface, options);
}

TEST(MissedBounds, AreToldWithFigures) {
  const ClosedSurface surface = cube(4);
  const auto missed = [&](const tetgen::TetrahedralizeOptions& options) {
    return missed_by(tetgen::tetrahedralize(surface.points, surface.triangles, options), options);
  };
  const auto length = missed({.edge_length = 1});
  ASSERT_EQ(length.size(), 1u);
  EXPECT_NE(length[0].find("18 of them on the surface; the longest is 5.657, 5.657 times"), std::string::npos)
      << length[0];
  EXPECT_TRUE(missed({.edge_length = 20}).empty());
  EXPECT_TRUE(missed({.max_volume = 0.1, .split_surface = true}).empty());
  EXPECT_EQ(missed({.max_volume = 1e-3}).size(), 1u) << "the surface is in the way";
  // Of a regular tetrahedron, the ratio is 0.612 and the angle 70.5 degrees.
  ClosedSurface regular;
  regular.points = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  regular.triangles.corners = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2};
  regular.triangles.vertices = 4;
  Tetrahedralization mesh = tetgen::tetrahedralize(regular.points, regular.triangles);
  ASSERT_EQ(mesh.tets.size(), 1u);
  EXPECT_TRUE(missed_by(mesh, {.radius_edge_ratio = 0.613, .min_dihedral = 70.5}).empty());
  EXPECT_EQ(missed_by(mesh, {.radius_edge_ratio = 0.612, .min_dihedral = 70.6}).size(), 2u);
}

}  // namespace multimesh::test
