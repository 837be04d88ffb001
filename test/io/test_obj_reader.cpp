// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <random>

#include "io_fixture.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/obj_reader.hpp"

namespace multimesh::io::test {
namespace {

using Corner = PolygonSoup::Corner;
const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\n";

class ObjReader : public IoTest {
 protected:
  PolygonSoup read(const std::string& text) const { return read_obj(file("a.obj", text)); }
  std::string refusal(const std::string& text) const {
    return error_of([&] { read(text); });
  }
};

void expect_face(const PolygonSoup& soup, std::size_t f, const std::vector<Corner>& corners) {
  ASSERT_LT(f, soup.face_count());
  const auto face = soup.face(f);
  EXPECT_EQ(std::vector<Corner>(face.begin(), face.end()), corners);
}

TEST_F(ObjReader, ReadsEveryFormOfCorner) {
  const auto soup = read(square + "f 1 2 3\nf 1/1 3/2 4/3\nf 1//1 2//1 4//1\nf 2/1/1 3/2/1 4/3/1\n");
  expect_face(soup, 0, {{0, -1, -1}, {1, -1, -1}, {2, -1, -1}});
  expect_face(soup, 1, {{0, 0, -1}, {2, 1, -1}, {3, 2, -1}});
  expect_face(soup, 2, {{0, -1, 0}, {1, -1, 0}, {3, -1, 0}});
  expect_face(soup, 3, {{1, 0, 0}, {2, 1, 0}, {3, 2, 0}});
}

TEST_F(ObjReader, NegativeIndicesCountBackFromTheFace) {
  const auto soup = read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -2 -1\n");
  expect_face(soup, 0, {{0}, {1}, {2}});
  expect_face(soup, 1, {{0}, {2}, {3}});
}

TEST_F(ObjReader, PositiveIndicesMayPointAhead) {
  EXPECT_EQ(read("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").face_count(), 1U);
}

TEST_F(ObjReader, LineEndsBlanksContinuationsAndCommentsDoNotMatter) {
  const std::string plain = "v 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3\n";
  for (const std::string& text :
       {std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0.5\r\nf 1 2 3\r\n"),
        std::string("v 0 0 0\rv 1 0 0\rv 0 1 .5\rf 1 2 3"),
        std::string("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0.5\nf 1 2 3"),
        std::string(
            "# path C:\\\n \tv\t0  0\t0 # origin\nv 1 \\\n 0 0\n\nv +0 1e0 5E-1\nf 1 \\\r\n2 3 \n")}) {
    const auto a = read(text), b = read(plain);
    EXPECT_EQ(a.positions, b.positions) << text;
    EXPECT_EQ(a.corners, b.corners) << text;
  }
}

TEST_F(ObjReader, ErrorsAfterContinuedLinesNameTheRightLine) {
  EXPECT_NE(refusal("v 0 0 \\\n0\nv 1 0 0\nv 0 1 x\n").find("a.obj:4: 'x'"), std::string::npos);
}

TEST_F(ObjReader, ColoursWeightsAndThirdTexcoords) {
  const auto soup = read("v 0 0 0 1 .5 0\nv 1 0 0 0 0 1\nv 0 1 0\nvt 1 2 3\nvt 4\nf 1 2 3\n");
  ASSERT_EQ(soup.colors.size(), 3U);
  EXPECT_EQ(soup.colors[0], (std::array<double, 3>{1, .5, 0}));
  EXPECT_EQ(soup.colors[2], (std::array<double, 3>{1, 1, 1}));
  EXPECT_EQ(soup.texcoords[1], (std::array<double, 2>{4, 0}));
  EXPECT_EQ(soup.notes.third_texcoords, 1U);
  EXPECT_EQ(read("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").notes.weights, 3U);
}

TEST_F(ObjReader, SectionsFollowTheStatements) {
  const auto soup = read(
      square +
      "f 1 2 3\no  box one\ng a b\nusemtl dark wood \ns 1\nf 1 2 4\ns off\nf 1 3 4\nusemtl red\nf 2 3 4\n");
  const auto section = [&](std::size_t f) { return soup.sections[soup.face_section[f]]; };
  EXPECT_EQ(section(0), PolygonSoup::Section{});
  EXPECT_EQ(section(1), (PolygonSoup::Section{"box one", "a b", "dark wood", "1"}));
  EXPECT_EQ(section(2), (PolygonSoup::Section{"box one", "a b", "dark wood", ""}));
  EXPECT_EQ(section(3).material, "red");
}

TEST_F(ObjReader, LibraryNamesWithBlanks) {
  file("my wood.mtl", "");
  const auto soup =
      read(square + "mtllib my wood.mtl\nmtllib a.mtl my wood.mtl b c.mtl\nmtllib x y\nf 1 2 3\n");
  EXPECT_EQ(soup.material_libraries, (std::vector<std::string>{"my wood.mtl", "a.mtl", "b c.mtl", "x", "y"}));
}

TEST_F(ObjReader, WhatIsLeftOutIsCountedAndTold) {
  const auto soup = read(square + "p 1\nl 1 2\nfoo 1\nbar\ncurv 0 1 1 2\nf 1 2 3\n");
  EXPECT_EQ(soup.notes.points, 1U);
  EXPECT_EQ(soup.notes.lines, 1U);
  EXPECT_EQ(soup.notes.unknown, 2U);
  EXPECT_EQ(soup.notes.curves, 1U);
  ASSERT_FALSE(soup.warnings.empty());
  EXPECT_NE(soup.warnings[0].find("a.obj:11: unknown statement 'foo'"), std::string::npos)
      << soup.warnings[0];
}

TEST_F(ObjReader, RepeatedCornersAndCollapsedFacesAreLeftOut) {
  const auto soup = read(square + "f 1 2 2 3 4 1\n");
  expect_face(soup, 0, {{0}, {1}, {2}, {3}});
  EXPECT_EQ(soup.notes.repeated_corners, 2U);
  EXPECT_EQ(read(square + "f 1 2 3\nf 1 2 1 2\n").notes.collapsed_faces, 1U);
  const auto kept = read_obj(file("b.obj", square + "f 1 1 2\nf 1 2 3\nf 3 3 3\nf 1 3 4\n"));
  expect_face(kept, 0, {{0}, {1}, {2}});
  expect_face(kept, 1, {{0}, {2}, {3}});
  EXPECT_EQ(kept.face_line, (std::vector<std::uint32_t>{10, 12}));
  EXPECT_EQ(kept.notes.collapsed_faces, 2U);
}

TEST_F(ObjReader, FlatFacesAreKeptRepeatedOnesLeftOutUnlessAskedFor) {
  const std::string good = square + "f 1 2 3\nf 1 3 4\nf 1 2 4\nf 2 3 4\nv 2 0 0\n";
  EXPECT_EQ(read(good + "f 1 2 5\n").notes.flat_faces, 1U);
  EXPECT_EQ(read(good + "f 3 1 2\n").notes.repeated_faces, 1U);
  EXPECT_EQ(read(good + "f 2 1 3\n").notes.repeated_faces, 1U);
  EXPECT_EQ(read(good + "f 2 1 3\n").face_count(), 4U);
  EXPECT_EQ(read_obj(file("b.obj", good + "f 2 1 3\n"), {.keep_repeated = true}).face_count(), 5U);
  EXPECT_NE(refusal(square + "v 2 0 0\nf 1 2 5\nf 1 2 2\n").find("a.obj:10: the face has no area"),
            std::string::npos);
}

TEST_F(ObjReader, EveryErrorNamesFileAndLine) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"v 0 0\n", ":1: the vertex has 2 numbers"},
      {"v 0 0 1,5\n", ":1: '1,5' is not a number"},
      {"v 0 0 1.#\n", ":1: '1.#' is not a number"},
      {"v 0 0 1.#IND\nv 0 0 0\nv 1 1 0\nf 2 1 3\n", ":1: the vertex is not finite"},
      {"v 0 0 nan\nv 0 0 0\nv 1 1 0\nf 2 1 3\n", ":1: the vertex is not finite"},
      {"v 0 0 1e999\nv 0 0 0\nv 1 1 0\nf 2 1 3\n", ":1: the vertex is not finite"},
      {square + "f 1 2\n", ":9: the face has 2 corners"},
      {square + "f 0 1 2\n", ":9: vertex index 0"},
      {square + "f -5 1 2\n", ":9: vertex index -5"},
      {square + "f 1 2 5\n", ":9: the face names vertex 5 but the file has 4"},
      {square + "f 1 2 99999999999999999999\n", ":9: '99999999999999999999'"},
      {square + "f 1 2 4294967297\n", ":9: vertex index 4294967297"},
      {square + "f 1 2 x\n", ":9: 'x'"},
      {square + "f 1/1/1/1 2 3\n", ":9: '1/1/1/1'"}};
  for (const auto& [text, message] : cases) {
    const std::string error = refusal(text);
    EXPECT_NE(error.find("a.obj" + message), std::string::npos) << text << error;
  }
}

TEST_F(ObjReader, TexcoordsThatDoNotExistAreForgottenWithAWarning) {
  const auto soup = read(square + "f 1/1 2/2 3/9\n");
  expect_face(soup, 0, {{0, 0}, {1, 1}, {2, -1}});
  EXPECT_EQ(soup.notes.missing_texcoords, 1U);
  EXPECT_EQ(soup.warnings.size(), 1U);
}

TEST_F(ObjReader, NumbersAreRoundedCorrectly) {
  const auto soup = read("v 0.1 123456789.123456789 1e-400\nv 4.9e-324 -0 1\nv 1 1 1\nf 1 2 3\n");
  EXPECT_EQ(soup.positions[0], (std::array<double, 3>{0.1, 123456789.123456789, 0}));
  EXPECT_EQ(soup.positions[1][0], 4.9e-324);
  EXPECT_TRUE(std::signbit(soup.positions[1][1]));
}

TEST_F(ObjReader, DamagedBytesGiveAnErrorOrASoupWithValidIndices) {
  const std::string text =
      square + "usemtl a\nf 1/1/1 2/2/1 3/3/1\nf -4//1 -2//1 -1//1\ns 1\nmtllib a b.mtl\nf 1 2 3 4\\\n 1\n";
  std::mt19937 random(7);
  for (int run = 0; run < 3000; ++run) {
    std::string damaged = text;
    for (int n = 0; n < 1 + run % 4; ++n)
      damaged[random() % damaged.size()] = "0123456789 /-.#\\\n\r\tvfnte\0\xFF"[random() % 26];
    damaged.resize(damaged.size() - random() % 20);
    PolygonSoup soup;
    if (!error_of([&] { soup = parse_obj(damaged, directory / "d.obj"); }).empty()) continue;
    for (const Corner& c : soup.corners) {
      ASSERT_TRUE(c.v >= 0 && c.v < static_cast<int>(soup.positions.size())) << damaged;
      ASSERT_TRUE(c.vt >= -1 && c.vt < static_cast<int>(soup.texcoords.size())) << damaged;
      ASSERT_TRUE(c.vn >= -1 && c.vn < static_cast<int>(soup.normals.size())) << damaged;
    }
  }
}

TEST_F(ObjReader, ReadMeshGoesByTheExtension) {
  EXPECT_EQ(read_mesh(file("A.OBJ", square + "f 1 2 3\n")).face_count(), 1U);
  EXPECT_NE(error_of([&] { read_mesh(file("a.stl", square)); }).find("not an STL file"), std::string::npos);
  EXPECT_NE(error_of([&] { read_mesh(file("a", square)); }).find("no extension"), std::string::npos);
}

}  // namespace
}  // namespace multimesh::io::test
