// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/medit_reader.hpp"
#include "adapters/io/mfem_reader.hpp"
#include "adapters/io/tetgen_files.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

SimplexSoup medit(const std::string& rest) {
  return parse_medit(
      "MeshVersionFormatted 2 Dimension 3\nVertices 4\n0 0 0 1\n1 0 0 0\n0 1 0 -2\n0 0 1 0\n" + rest,
      "a.mesh");
}
std::string medit_refusal(const std::string& rest) {
  return error_of([&] { medit(rest); });
}

TEST(MeditReader, ListsMayComeBeforeWhatTheyName) {
  const SimplexSoup soup =
      medit("Ridges 1\n2\nCorners 2\n3 1\nRequiredVertices 1\n3\nEdges 2\n1 2 5\n2 3 6\nEnd\n");
  EXPECT_EQ(soup.simplices[1].flags, (std::vector<std::uint8_t>{0, feature_flag}));
  EXPECT_EQ(soup.simplices[0].corners, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(soup.simplices[0].tags, (std::vector<std::int32_t>{1, -2}));
  EXPECT_EQ(soup.simplices[0].flags, (std::vector<std::uint8_t>{feature_flag, feature_flag | required_flag}));
  EXPECT_EQ(soup.point_tags, (std::vector<std::int32_t>{1, 0, -2, 0}));
}

TEST(MeditReader, UnknownSectionsAndAMissingEndAreNoted) {
  const SimplexSoup soup = medit("Normals 1\n0 0 1\nTetrahedra 1\n1 2 3 4 9 # the only one\n");
  EXPECT_EQ(soup.simplices[3].tags, std::vector<std::int32_t>{9});
  ASSERT_EQ(soup.warnings.size(), 2U);
  EXPECT_NE(soup.warnings[0].find("does not end with End"), std::string::npos);
  EXPECT_EQ(soup.warnings[1], "a.mesh: left out: Normals");
}

TEST(MeditReader, TwoDimensionsAndQuadrilaterals) {
  const SimplexSoup soup = parse_medit(
      "MeshVersionFormatted 1\nDimension\n2\nVertices\n4\n0 0 1\n1 0 1\n1 1 1\n0 1 1\nQuadrilaterals\n1\n1 2 "
      "3 4 8\n"
      "End",
      "a.mesh");
  EXPECT_EQ(soup.points[2], (std::array<double, 3>{1, 1, 0}));
  EXPECT_EQ(soup.simplices[2].tags, (std::vector<std::int32_t>{8, 8}));
}

TEST(MeditReader, FlagsStayWithTheirSimplicesWhenOthersAreLeftOut) {
  const SimplexSoup soup = parse_medit(
      "MeshVersionFormatted 1 Dimension 3 Vertices 3 0 0 0 0 1 0 0 0 0 1 0 0 Edges 3 1 1 4 1 2 5 2 3 6 "
      "Ridges 1 3 End",
      "a.mesh", {.max_collapsed_share = 1});
  EXPECT_EQ(soup.simplices[1].tags, (std::vector<std::int32_t>{5, 6}));
  EXPECT_EQ(soup.simplices[1].flags, (std::vector<std::uint8_t>{0, feature_flag}));
}

TEST(MeditReader, ErrorsNameTheLineAndTheRemedy) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"Tetrahedra 1\n1 2 3 5 9\nEnd", "a.mesh:8: the element names point 5 but the file has 4"},
      {"Tetrahedra 1\n0 2 3 4 9\nEnd", "a.mesh:8: point number 0 is out of range; points count from 1"},
      {"Tetrahedra 2\n1 2 3 4 9\nEnd", "a.mesh:9: 'End' is not a whole number"},
      {"Tetrahedra 0\n1 2 3 4 9\nEnd", "a.mesh:8: a section has to begin here, not '1'"},
      {"Tetrahedra 99999999999\n1 2 3 4 9\nEnd", "a.mesh:7: the file is too short for 99999999999 elements"},
      {"Hexahedra 1\n1 2 3 4 1 2 3 4 0\nEnd", "a.mesh:8: the element is a hexahedron"},
      {"Edges 1\n1 2 3\nRidges 1\n2\nEnd", "a.mesh:10: edge number 2 is out of range; the file has 1"},
      {"Corners 1\n9\nEnd", "a.mesh:8: the element names point 9 but the file has 4"},
      {"Dimension 4\n", "a.mesh:7: the dimension is 4"},
      {"End", "no tetrahedron, triangle, edge or vertex"}};
  for (const auto& [text, expected] : cases)
    EXPECT_NE(medit_refusal(text).find(expected), std::string::npos) << medit_refusal(text);
}

const std::string mfem_mesh =
    "MFEM mesh v1.0\n\n# comment\ndimension\n3\nelements\n1\n7 4 0 1 2 3\nboundary\n2\n5 2 0 1 2\n6 3 0 1 3 "
    "2\n"
    "vertices\n4\n3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

TEST(MfemReader, ElementsBoundaryAndVertices) {
  const SimplexSoup soup = parse_mfem(mfem_mesh, "a.mesh");
  EXPECT_EQ(soup.simplices[3].tags, std::vector<std::int32_t>{7});
  EXPECT_EQ(soup.simplices[2].tags, (std::vector<std::int32_t>{5, 6, 6}));
  EXPECT_EQ(soup.points[3], (std::array<double, 3>{0, 0, 1}));
}

TEST(MfemReader, OtherFormatsOfMfemAreRefusedWithTheReason) {
  const auto refusal = [](const std::string& text) { return error_of([&] { parse_mfem(text, "a.mesh"); }); };
  EXPECT_NE(refusal("MFEM NURBS mesh v1.0\n").find("only 'MFEM mesh v1.0' is read"), std::string::npos);
  const std::string periodic =
      mfem_mesh.substr(0, mfem_mesh.find("3\n0 0 0")) + "\nnodes\nFiniteElementSpace\n";
  EXPECT_NE(refusal(periodic).find("curved or periodic"), std::string::npos);
  EXPECT_NE(refusal(mfem_mesh.substr(0, mfem_mesh.find("vertices"))).find("ends before the section vertices"),
            std::string::npos);
}

class TetGenFiles : public IoTest {
 protected:
  fs::path node(const std::string& text) const { return file("a.node", text); }
  fs::path ele(const std::string& text) const { return file("a.ele", text); }
  std::string refusal() const {
    return error_of([&] { read_simplices(directory / "a.ele"); });
  }
};

TEST_F(TetGenFiles, EitherFileNamesThePair) {
  node("# nodes\n4 3 1 1\n0 0 0 0 0.5 1\n1 1 0 0 0.5 0\n2 0 1 0 0.5 0\n3 0 0 1 0.5 -1\n");
  ele("1 4 1\n0 0 1 2 3 4.0\n# end\n");
  for (const char* name : {"a.node", "a.ele"}) {
    const SimplexSoup soup = read_simplices(directory / name);
    EXPECT_EQ(soup.simplices[3].corners, (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(soup.simplices[3].tags, std::vector<std::int32_t>{4});
    EXPECT_EQ(soup.point_tags, (std::vector<std::int32_t>{1, 0, 0, -1}));
  }
}

TEST_F(TetGenFiles, TenNodesAndFractionsForTags) {
  node(
      "10 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 2\n6 0 0 2\n7 0 0 2\n8 0 0 2\n9 0 0 2\n10 0 0 "
      "2\n");
  ele("1 10 1\n1 1 2 3 4 5 6 7 8 9 10 0.5\n");
  const SimplexSoup soup = read_simplices(directory / "a.node");
  EXPECT_EQ(soup.simplices[3].tags, std::vector<std::int32_t>{0});
  EXPECT_EQ(soup.notes.high_order, 1U);
}

// Two tetrahedra: of the boundary two faces are listed, one with a neighbour behind its marker.
TEST_F(TetGenFiles, FacesAndEdgesHaveTheirMarkersAsTags) {
  node("5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n");
  ele("2 4 0\n1 1 2 3 4\n2 2 3 4 5\n");
  file("a.face", "# faces\n1 1\n1 1 2 3 -1 7 # -1\n");
  file("a.edge", "1 1\n1 1 2 9\n");
  const SimplexSoup some = read_simplices(directory / "a.ele");
  EXPECT_EQ(some.simplices[2].corners, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(some.simplices[2].tags, std::vector<std::int32_t>{-1});
  EXPECT_EQ(some.simplices[1].corners, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(some.simplices[1].tags, std::vector<std::int32_t>{9});
}

TEST_F(TetGenFiles, OfAListOfAllFacesThoseWithMarkersAreKept) {
  node("5 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n");
  ele("2 4 0\n1 1 2 3 4\n2 2 3 4 5\n");
  file("a.face", "7 1\n1 1 2 3 5\n2 1 2 4 5\n3 1 3 4 6\n4 2 3 4 0\n5 2 3 5 6\n6 2 4 5 6\n7 3 4 5 6\n");
  EXPECT_EQ(read_simplices(directory / "a.ele").simplices[2].tags,
            (std::vector<std::int32_t>{5, 5, 6, 6, 6, 6}));
  file("a.face", "1 0\n1 2 3 4\n");
  EXPECT_EQ(read_simplices(directory / "a.ele").simplices[2].tags, std::vector<std::int32_t>{0})
      << "listed, though without a marker";
  file("a.face", "1 1\n1 2 3 9 1\n");
  EXPECT_NE(refusal().find("names point 9"), std::string::npos);
}

TEST_F(TetGenFiles, Errors) {
  node("4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n");
  EXPECT_NE(refusal().find("a.ele: the file does not exist"), std::string::npos);
  ele("1 4 0\n1 1 2 3 5\n");
  EXPECT_NE(refusal().find("a.ele:2: the element names point 5 but the file has 4"), std::string::npos);
  ele("2 4 0\n1 1 2 3 4\n3 1 2 3 4\n");
  EXPECT_NE(refusal().find("a.ele:3: entry 3 comes where 2 should"), std::string::npos);
  ele("9999999999 4 0\n1 1 2 3 4\n");
  EXPECT_NE(refusal().find("too short for 9999999999 tetrahedra"), std::string::npos);
  ele("1 8 0\n1 1 2 3 4 1 2 3 4\n");
  EXPECT_NE(refusal().find("tetrahedra have 4 or 10"), std::string::npos);
}

}  // namespace
}  // namespace multimesh::io::test
