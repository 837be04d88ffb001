// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/group_tags.hpp"
#include "adapters/io/msh_reader.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

std::string msh2(const std::string& elements, const std::string& more = {}) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n10 0 0 0\n20 1 0 0\n30 0 1 0\n40 0 0 1\n50 1 1 1\n"
         "$EndNodes\n$Elements\n" +
         elements + "$EndElements\n" + more;
}

std::string msh4(const std::string& entities, const std::string& elements) {
  return "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n" + entities +
         "$Nodes\n2 5 1 9\n0 1 0 1\n9\n0 0 0\n3 5 1 4\n1\n2\n3\n4\n1 0 0 .1 .1 .1\n0 1 0 .2 .2 .2\n"
         "0 0 1 .3 .3 .3\n1 1 1 .4 .4 .4\n$EndNodes\n$Elements\n" +
         elements + "$EndElements\n";
}

SimplexSoup parse(const std::string& text) {
  return parse_msh(text, "a.msh");
}
std::string refusal(const std::string& text) {
  return error_of([&] { parse(text); });
}

TEST(MshReader, NodesMayHaveAnyNumbers) {
  const SimplexSoup soup = parse(msh2("1\n1 4 2 3 1 50 20 30 40\n"));
  EXPECT_EQ(soup.simplices[3].corners, (std::vector<std::uint32_t>{4, 1, 2, 3}));
  EXPECT_EQ(soup.simplices[3].tags, std::vector<std::int32_t>{3});
  EXPECT_EQ(soup.points[4], (std::array<double, 3>{1, 1, 1}));
}

TEST(MshReader, EntityTagsOnlyWhereTheDimensionHasNoPhysicalOnes) {
  const SimplexSoup soup = parse(
      msh2("4\n1 4 2 0 8 10 20 30 40\n2 4 2 3 9 20 30 40 50\n3 2 2 0 5 10 20 30\n4 2 3 0 6 0 20 30 40\n"));
  EXPECT_EQ(soup.simplices[3].tags, (std::vector<std::int32_t>{0, 3}));
  EXPECT_EQ(soup.simplices[2].tags, (std::vector<std::int32_t>{5, 6}));
  EXPECT_EQ(soup.notes.entity_tags, 2U);
}

TEST(MshReader, ElementsWithoutTags) {
  EXPECT_EQ(parse(msh2("1\n1 4 0 10 20 30 40\n")).simplices[3].tags, std::vector<std::int32_t>{0});
}

TEST(MshReader, Version4TakesPhysicalTagsFromEntities) {
  const std::string entities =
      "$Entities\n0 0 0 2\n5 0 0 0 1 1 1 2 -30 31 0\n6 0 0 0 1 1 1 0 1 -4\n$EndEntities\n";
  const SimplexSoup soup = parse(msh4(entities, "2 2 1 2\n3 5 4 1\n1 9 1 2 3\n3 6 4 1\n2 1 2 3 4\n"));
  EXPECT_EQ(soup.simplices[3].tags, (std::vector<std::int32_t>{32, 0}));
  EXPECT_EQ(soup.tag_sets, (std::vector<SimplexSoup::TagSet>{{3, 32, {30, 31}}}))
      << "one element, two groups";
  EXPECT_EQ(soup.simplices[3].corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 1, 2, 3, 4}));
  EXPECT_EQ(soup.points[1], (std::array<double, 3>{1, 0, 0}));  // behind it, parametric coordinates
}

TEST(MshReader, Version4WithoutEntitiesHasEntityTags) {
  const SimplexSoup soup = parse(msh4("", "2 2 1 2\n3 5 4 1\n1 9 1 2 3\n3 6 4 1\n2 1 2 3 4\n"));
  EXPECT_EQ(soup.simplices[3].tags, (std::vector<std::int32_t>{5, 6}));
}

// Node 2 on a curve, node 3 on a surface: one and two parameters behind the coordinates.
TEST(MshReader, ParametricNodesAreNodes) {
  const SimplexSoup soup = parse(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$ParametricNodes\n4\n1 0 0 0 0 17\n2 1 0 0 1 26 5.5\n"
      "3 0 1 0 2 4 .5 .25\n4 0 0 1 3 1\n$EndParametricNodes\n"
      "$Elements\n1\n1 4 2 3 1 1 2 3 4\n$EndElements\n");
  EXPECT_EQ(soup.points, (std::vector<std::array<double, 3>>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_TRUE(soup.warnings.empty());
}

TEST(MshReader, ElementsListedOncePerGroupAreOneElement) {
  const SimplexSoup soup = parse(
      msh2("6\n1 4 2 3 1 10 20 30 40\n2 4 2 5 1 10 20 30 40\n3 4 2 5 1 20 30 40 50\n4 2 2 7 1 10 20 30\n"
           "5 2 2 8 1 30 10 20\n6 2 2 8 1 10 20 40\n"));
  EXPECT_EQ(soup.simplices[3].corners, (std::vector<std::uint32_t>{0, 1, 2, 3, 1, 2, 3, 4}));
  EXPECT_EQ(groups_of(soup, 3, soup.simplices[3].tags[0]), (std::vector<std::int32_t>{3, 5}));
  EXPECT_EQ(groups_of(soup, 3, soup.simplices[3].tags[1]), std::vector<std::int32_t>{5});
  EXPECT_EQ(tags_with(soup, 3, 5), (std::vector<std::int32_t>{5, soup.simplices[3].tags[0]}));
  ASSERT_EQ(soup.simplices[2].size(), 2U);
  EXPECT_EQ(groups_of(soup, 2, soup.simplices[2].tags[0]), (std::vector<std::int32_t>{7, 8}));
  EXPECT_EQ(soup.notes.doubled, 0U);
  EXPECT_TRUE(soup.warnings.empty()) << "all is kept";
}

TEST(MshReader, DoubledElementsAreLeftOutAndTold) {
  const SimplexSoup soup =
      parse(msh2("3\n1 4 2 3 1 10 20 30 40\n2 4 2 3 1 20 10 40 30\n3 4 2 3 1 20 30 40 50\n"));
  EXPECT_EQ(soup.simplices[3].size(), 2U);
  EXPECT_EQ(soup.simplices[3].tags, (std::vector<std::int32_t>{3, 3}));
  EXPECT_EQ(soup.notes.doubled, 1U);
  EXPECT_NE(soup.warnings.at(0).find("1 elements are listed again"), std::string::npos);
}

// One volume in two partitions, with the triangle between them.
TEST(MshReader, PartitionsAreDroppedAndTheirEntityIsKept) {
  const std::string partitions =
      "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 7 0\n$EndEntities\n$PartitionedEntities\n2\n0\n0 0 1 2\n"
      "9 3 1 2 1 2 0 0 0 1 1 1 1 7 0\n5 3 1 1 1 0 0 0 1 1 1 1 7 0\n6 3 1 1 2 0 0 0 1 1 1 1 7 0\n"
      "$EndPartitionedEntities\n";
  const SimplexSoup soup =
      parse(msh4(partitions, "3 3 1 3\n2 9 2 1\n3 1 2 3\n3 5 4 1\n1 9 1 2 3\n3 6 4 1\n2 1 2 3 4\n"));
  EXPECT_EQ(soup.simplices[3].tags, (std::vector<std::int32_t>{7, 7}));
  EXPECT_EQ(soup.simplices[2].size(), 0U);
  EXPECT_NE(soup.warnings.at(0).find("the partitions are dropped, and 1 elements between them"),
            std::string::npos);
  const SimplexSoup old = parse(msh2("1\n1 4 4 3 1 1 2 10 20 30 40\n"));
  EXPECT_EQ(old.simplices[3].tags, std::vector<std::int32_t>{3});
  EXPECT_NE(old.warnings.at(0).find("the partitions are dropped"), std::string::npos);
}

TEST(MshReader, QuadsAreCut) {
  const SimplexSoup soup = parse(msh2("3\n1 2 2 4 1 10 20 40\n2 3 2 5 1 10 20 50 30\n3 1 2 6 1 10 20\n"));
  EXPECT_EQ(soup.simplices[2].tags, (std::vector<std::int32_t>{4, 5, 5}));
  EXPECT_EQ(soup.notes.cut_polygons, 1U);
  EXPECT_NE(soup.warnings.at(0).find("1 polygons of four or more corners are cut"), std::string::npos);
}

TEST(MshReader, QuadsHaveEntityTagsToo) {
  const SimplexSoup soup = parse(msh2("2\n1 2 2 0 1 10 20 40\n2 3 2 0 5 10 20 50 30\n"));
  EXPECT_EQ(soup.simplices[2].tags, (std::vector<std::int32_t>{1, 5, 5}));
}

TEST(MshReader, OtherVolumesAreRefused) {
  EXPECT_EQ(refusal(msh2("2\n1 4 0 10 20 30 40\n2 7 0 10 20 30 40 50\n")),
            "a.msh:15: the element is a pyramid; of volumes only tetrahedra are read, split the mesh into "
            "tetrahedra");
  EXPECT_NE(refusal(msh2("1\n1 999 0 10 20 30 40\n")).find("a.msh:14: element type 999 is not known"),
            std::string::npos);
}

TEST(MshReader, HighOrderElementsKeepTheirCorners) {
  const SimplexSoup soup = parse(msh2("1\n1 9 2 1 1 10 20 30 40 50 10\n"));
  EXPECT_EQ(soup.simplices[2].corners, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(soup.notes.high_order, 1U);
  EXPECT_EQ(soup.notes.unused_points, 2U);
}

TEST(MshReader, RepeatedVerticesAreLeftOut) {
  const std::string text = msh2("2\n1 4 0 10 20 30 40\n2 4 0 10 20 30 10\n");
  EXPECT_NE(error_of([&] {
              parse_msh(text, "a.msh", {.max_collapsed_share = 0});
            }).find("a.msh:15: the tetrahedron names a point twice (1 of 2 tetrahedra"),
            std::string::npos);
  const SimplexSoup soup = parse(text);
  EXPECT_EQ(soup.simplices[3].size(), 1U);
  EXPECT_EQ(soup.notes.repeated_vertex, 1U);
  EXPECT_NE(soup.warnings.at(0).find("a.msh:15: the tetrahedron names a point twice and is left out"),
            std::string::npos);
}

TEST(MshReader, PeriodicLinksOfBothVersions) {
  const SimplexSoup old =
      parse(msh2("1\n1 4 0 10 20 30 40\n",
                 "$Periodic\n2\n2 14 22\nAffine 1 0 0 0 0 1 0 0 0 0 1 2.2 0 0 0 1\n2\n10 40\n"
                 "20 50\n0 1 2\n1\n30 20\n$EndPeriodic\n"));
  ASSERT_EQ(old.periodic.size(), 2U);
  EXPECT_EQ(old.periodic[0].affine.size(), 16U);
  EXPECT_EQ(old.periodic[0].points, (std::vector<std::array<std::uint32_t, 2>>{{0, 3}, {1, 4}}));
  EXPECT_EQ(old.periodic[1], (SimplexSoup::Periodic{0, 1, 2, {}, {{2, 1}}}));
  const SimplexSoup now =
      parse(msh4("", "1 1 1 1\n3 5 4 1\n1 9 1 2 3\n") + "$Periodic\n1\n0 17 11\n0\n1\n9 4\n$EndPeriodic\n");
  EXPECT_EQ(now.periodic.at(0), (SimplexSoup::Periodic{0, 17, 11, {}, {{0, 4}}}));
}

TEST(MshReader, NamesOfGroupsAndUnknownSections) {
  const SimplexSoup soup =
      parse("$Comments\nany thing\n$EndComments\n" + msh2("1\n1 4 0 10 20 30 40\n",
                                                          "$PhysicalNames\n2\n3 1 \"a b\"\n2 7 \"c\"\n"
                                                          "$EndPhysicalNames\n$Own\n$x\n$EndOwn\n"));
  EXPECT_EQ(soup.groups, (std::vector<SimplexSoup::Group>{{3, 1, "a b"}, {2, 7, "c"}}));
  EXPECT_EQ(soup.warnings.back(), "a.msh: left out: $Own");
}

TEST(MshReader, ErrorsNameTheLineAndTheRemedy) {
  const std::string good = msh2("1\n1 4 0 10 20 30 40\n");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {msh2("1\n1 4 0 10 20 30 77\n"), "a.msh:14: node 77 is named, but the section $Nodes does not have it"},
      {msh2("1\n1 4 0 10 20 30 x\n"), "a.msh:14: 'x' is not a whole number"},
      {msh2("2\n1 4 0 10 20 30 40\n"), "a.msh:15: '$EndElements' is not a whole number"},
      {msh2("0\n1 4 0 10 20 30 40\n"), "a.msh:14: the section '$Elements' has to end here"},
      {msh2("0\n"), "a.msh: the file has no tetrahedron, triangle, edge or vertex"},
      {msh2("-1\n"), "a.msh:13: the number of elements is negative"},
      {msh2("1000000000000\n1 4 0 10 20 30 40\n"),
       "a.msh:13: the file is too short for 1000000000000 elements"},
      {good.substr(0, good.find("$Elements")), "the file ends before the section $Elements"},
      {good.substr(good.find("$Nodes")), "the file has no section $MeshFormat"},
      {"$MeshFormat\n4 0 8\n$EndMeshFormat\n", "a.msh:2: version '4' of Gmsh's format is not read"},
      {"$NOD\n1\n", "a.msh:1: this is version 1 of Gmsh's format"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 nan 0\n$EndNodes\n",
       "a.msh:6: the point is not finite"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 0 0 0\n1 0 0 0\n$EndNodes\n",
       "a.msh:8: there are two nodes of number 1"},
      {"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Elements\n1\n1 15 0 1\n$EndElements\n",
       "a.msh:6: node 1 is named, but the section $Nodes does not come before this one"}};
  for (const auto& [text, expected] : cases)
    EXPECT_NE(refusal(text).find(expected), std::string::npos) << refusal(text);
}

TEST(MshReader, BinaryOfTheOtherByteOrder) {
  const auto big = [](auto value) {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof(value));
    return std::string(bytes.rbegin(), bytes.rend());
  };
  const std::string text = "$MeshFormat\n2.2 1 8\n" + big(1) + "\n$EndMeshFormat\n$Nodes\n1\n" + big(5) +
                           big(0.5) + big(-2.0) + big(0.1) + "\n$EndNodes\n$Elements\n1\n" + big(15) +
                           big(1) + big(2) + big(1) + big(7) + big(8) + big(5) + "\n$EndElements\n";
  const SimplexSoup soup = parse_msh(text, "a.msh");
  EXPECT_EQ(soup.points.at(0), (std::array<double, 3>{0.5, -2, 0.1}));
  EXPECT_EQ(soup.simplices[0].tags, std::vector<std::int32_t>{7});
}

}  // namespace
}  // namespace multimesh::io::test
