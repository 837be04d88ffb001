// SPDX-License-Identifier: BSD-3-Clause
// Tetrahedra read and written in two lines, with regions, patches, curves and their names.
#include "multimesh/files/domain_file.hpp"
#include "multimesh/files/surface_file.hpp"
#include "test/domain/box.hpp"
#include "test/files/folder.hpp"

namespace multimesh::files::test {
namespace {

class Domain : public InFolder {
 protected:
  /// Two regions with names, a patch and a curve.
  static TaggedTetrahedra two_regions() {
    TaggedTetrahedra t = multimesh::test::box(2, 1, 1, [](Index x, Index, Index) { return x == 0 ? 3 : 8; });
    const auto at = [&](double x, double y, double z) { return multimesh::test::point_of(t, x, y, z); };
    t.triangles.corners = {at(0, 0, 0), at(0, 1, 0), at(0, 1, 1)};
    t.patches = {5};
    t.edges.corners = {at(0, 0, 0), at(1, 0, 0)};
    t.edge_tags = {9};
    t.triangles.vertices = t.edges.vertices = static_cast<Index>(t.points.size());
    return t;
  }
  static DomainGroups names() {
    return {{{3, 3, "steel"}, {3, 8, "glass"}, {2, 5, "inlet"}, {1, 9, "rail"}}, {}};
  }
  std::filesystem::path written(const char* name) const {
    write_domain(folder / name, two_regions(), names());
    return folder / name;
  }
};

TEST_F(Domain, IsTheSameWhenItIsWrittenAndRead) {
  DomainFile file = read_domain(written("in.msh"), {.no_periodic = true});
  const TetDomain domain = take_domain(file);
  EXPECT_EQ(write_domain(folder / "out.msh", domain, file), std::vector<std::string>{});
  DomainFile again = read_simplices(folder / "out.msh");
  EXPECT_EQ(again.groups().groups, read_simplices(folder / "in.msh").groups().groups);
  TaggedTetrahedra before = two_regions(), after = take_tetrahedra(again);
  std::ranges::sort(before.points);  // their order is that of the tetrahedra
  std::ranges::sort(after.points);
  EXPECT_EQ(after.points, before.points);
  EXPECT_EQ(after.tets.size(), before.tets.size());
  EXPECT_EQ(std::ranges::count(after.regions, 3), std::ranges::count(before.regions, 3));
  EXPECT_EQ(after.patches, before.patches);
  EXPECT_EQ(after.edge_tags, before.edge_tags);
}

TEST_F(Domain, WhatIsNotListedIsWrittenIfAskedFor) {
  DomainFile file = read_domain(written("in.msh"), {.no_periodic = true});
  const TetDomain domain = take_domain(file);
  write_domain(folder / "out.msh", domain, file, {.unlisted = {false, false, true}});
  const DomainFile again = read_simplices(folder / "out.msh");
  EXPECT_TRUE(std::ranges::any_of(again.soup.groups, [](const auto& g) { return g.name == "interfaces"; }));
}

TEST_F(Domain, GroupsAreFoundByTagsAndNames) {
  const DomainFile file = read_simplices(written("in.msh"));
  EXPECT_EQ(tags_of_patches(file, {"inlet"}, "lock"), std::vector<std::int32_t>{5});
  EXPECT_EQ(tags_of_groups(file, 3, {8}, "lock"), std::vector<std::int32_t>{8});
  const std::string why = refusal([&] { tags_of_groups(file, 3, {7}, "lock"); });
  EXPECT_NE(why.find("it has 3, 8"), std::string::npos) << why;
}

TEST_F(Domain, PointsAtOnePlaceAreToldOrJoined) {
  const auto path = write("in.mesh",
                          "MeshVersionFormatted 2\nDimension 3\nVertices 8\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                          "0 0 1 0\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 -1 0\n"
                          "Tetrahedra 2\n1 2 3 4 1\n5 7 6 8 1\nEnd\n");
  DomainFile apart = read_domain(path);
  EXPECT_TRUE(any_has(apart.warnings, "3 points are at the place of another one"));
  DomainFile joined = read_domain(path, {.weld = 0});
  EXPECT_EQ(take_tetrahedra(joined).points.size(), 5U);
  EXPECT_FALSE(any_has(read_domain(path, {.no_weld = true}).warnings, "at the place"));
}

TEST_F(Domain, WarningsOfTheDomainAreValues) {
  TaggedTetrahedra t = two_regions();
  t.edges.corners = {0, static_cast<Index>(t.points.size() - 1)};  // from end to end of the box
  write_domain(folder / "in.msh", t, {});
  DomainFile file = read_domain(folder / "in.msh", {.no_periodic = true});
  testing::internal::CaptureStderr();
  (void)take_domain(file);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_TRUE(any_has(file.warnings, "1 listed edges are no edge of a tetrahedron; left out"));
}

TEST_F(Domain, ErrorsNameTheFileAndWhatToDo) {
  const auto surface = write("in.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  DomainFile file = read_domain(surface);
  const std::string why = refusal([&] { take_domain(file); });
  EXPECT_NE(why.find("in.obj: has no tetrahedron"), std::string::npos) << why;
  EXPECT_NE(why.find("multimesh tetrahedralize"), std::string::npos) << why;
}

TEST_F(Domain, TrianglesOfAFileWithTagsHaveGroups) {
  TaggedTetrahedra t = two_regions();
  t.tets.corners.clear();
  t.regions.clear();
  write_domain(folder / "in.msh", t, names());
  const SurfaceFile file = read_surface(folder / "in.msh");
  ASSERT_EQ(file.input.triangles.size(), 1U);
  EXPECT_EQ(file.section_of(0).group, "inlet");
}

}  // namespace
}  // namespace multimesh::files::test
