// SPDX-License-Identifier: BSD-3-Clause
// Harmless errors in a file: it is read, and a warning reports them.
#include <array>
#include <cmath>
#include <random>

#include "io_fixture.hpp"
#include "multimesh/io/mesh_reader.hpp"

namespace multimesh::io::test {
namespace {

constexpr std::array nonfinite = {"nan",      "-nan",      "NaN",    "inf",     "-inf",    "1e999",
                                  "nan(ind)", "-1.#IND00", "1.#INF", "1.#QNAN", "-1.#INF0"};

PolygonSoup obj(const std::string& text, const ReadOptions& options = {}) {
  return parse_mesh(text, "a.obj", options);
}

std::size_t mentions(const PolygonSoup& soup, const std::string& part) {
  return static_cast<std::size_t>(std::ranges::count_if(
      soup.warnings, [&](const std::string& w) { return w.find(part) != std::string::npos; }));
}

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string square_vt = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST(NotFinite, WhatNoFaceNamesIsIgnored) {
  for (const std::string bad : nonfinite) {
    const auto soup = obj("v 0 " + bad + " 0\n" + square + "vt " + bad + " 0\n" + square_vt + "vn 0 0 " +
                          bad + "\nf 2/2/1 3/3/1 4/4/1 5/5/1\n");
    EXPECT_EQ(soup.notes.nonfinite_positions, 1U) << bad;
    EXPECT_EQ(soup.notes.nonfinite_texcoords, 0U) << bad;
    EXPECT_EQ(soup.notes.nonfinite_normals, 1U) << bad;
    EXPECT_EQ(mentions(soup, "1 vertices that no face names"), 1U) << bad;
    EXPECT_EQ(mentions(soup, "1 texture coordinates that no face names"), 1U) << bad;
    for (const auto& p : soup.positions)
      for (const double x : p) EXPECT_TRUE(x >= 0 && x <= 1) << bad;
    for (const auto& t : soup.texcoords)
      for (const double x : t) EXPECT_TRUE(x >= 0 && x <= 1) << bad;
  }
}

TEST(NotFinite, ACornerLosesItsTextureCoordinateAndAVertexItsColour) {
  for (const std::string bad : nonfinite) {
    const auto soup =
        obj("v 0 0 0 0.5 " + bad + " 0.5\nv 1 0 0 0 0 0\nv 1 1 0 0 0 0\nv 0 1 0 0 0 0\nvt 0 0\nvt 1 " + bad +
            "\nf 1/1 2/2 3/2\nf 1/1 3/1 4/1\n");
    EXPECT_EQ(soup.notes.nonfinite_texcoords, 2U) << bad;
    EXPECT_EQ(soup.face(0)[0].vt, 0) << bad;
    EXPECT_EQ(soup.face(0)[1].vt, -1) << bad;
    EXPECT_EQ(soup.face(1)[1].vt, 0) << bad;
    EXPECT_EQ(soup.colors.at(0), (std::array<double, 3>{1, 1, 1})) << bad;
    EXPECT_EQ(soup.notes.nonfinite_colors, 1U) << bad;
    EXPECT_EQ(mentions(soup, "2 corners of the file have none now"), 1U) << bad;
  }
}

TEST(NotFinite, AVertexThatAFaceOrLineNamesIsRefused) {
  for (const std::string bad : nonfinite) {
    const std::string head = square + "v 0 0 " + bad + "\n";
    EXPECT_NE(error_of([&] { obj(head + "f 1 2 5\n"); }).find("a.obj:5: the vertex is not finite"),
              std::string::npos);
    EXPECT_NE(error_of([&] { obj(head + "f 1 2 3\nl 1 5\n", {.keep_lines = true}); }).find("a.obj:5"),
              std::string::npos);
  }
}

TEST(NotFinite, InOtherFormats) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\n"
      "property double s\nproperty double t\nelement face 1\nproperty list uchar int "
      "vertex_indices\nend_header\n";
  const auto soup = parse_mesh(ply + "0 0 0 0 0\n1 0 0 nan 0\nnan 0 0 0 0\n0 1 0 0 0\n3 0 1 3\n", "a.ply");
  EXPECT_EQ(soup.notes.nonfinite_positions, 1U);
  EXPECT_EQ(soup.face(0)[1].vt, -1);
  EXPECT_NE(error_of([&] {
              parse_mesh(ply + "0 0 0 0 0\n1 0 0 0 0\nnan 0 0 0 0\n0 1 0 0 0\n3 0 1 2\n", "a.ply");
            }).find("a.ply:14: the vertex is not finite"),
            std::string::npos);
  const auto read = parse_mesh(
      "STNOFF\n4 1 0\n0 0 0 nan 0 0 nan 0\n1 0 0 0 0 1 0 0\n1 1 0 0 0 1 1 1\n"
      "nan 1 0 0 0 1 1 1\n3 0 1 2\n",
      "a.off");
  EXPECT_EQ(read.notes.nonfinite_positions, 1U);
  EXPECT_EQ(read.notes.nonfinite_normals, 1U);
  EXPECT_EQ(read.notes.nonfinite_texcoords, 1U);
}

// Whatever their share: the other faces are read.
TEST(LeftOut, RepeatedAndCollapsedFacesAmongGoodOnes) {
  std::mt19937 random(3);
  for (int round = 0; round < 60; ++round) {
    constexpr int n = 6;
    std::string text;
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) text += "v " + std::to_string(x) + " " + std::to_string(y) + " 0\n";
    std::size_t good = 0, repeated = 0, collapsed = 0;
    const int share = round % 4;  // every face doubled, every second, some, none
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        std::array<int, 4> q{y * (n + 1) + x + 1, y * (n + 1) + x + 2, (y + 1) * (n + 1) + x + 2,
                             (y + 1) * (n + 1) + x + 1};
        const auto face = [&](int a, int b, int c) {
          text += "f " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
        };
        face(q[0], q[1], q[2]);
        face(q[0], q[2], q[3]);
        good += 2;
        if (share == 0 || (share == 1 && random() % 2 == 0) || (share == 2 && random() % 9 == 0)) {
          std::array<int, 3> t{q[0], q[1], q[2]};
          std::ranges::shuffle(t, random);
          face(t[0], t[1], t[2]);
          ++repeated;
        }
        if (share != 3 && random() % 3 == 0) {
          face(q[0], q[1], q[random() % 2]);
          ++collapsed;
        }
      }
    const auto soup = obj(text);
    EXPECT_EQ(soup.face_count(), good);
    EXPECT_EQ(soup.notes.repeated_faces, repeated);
    EXPECT_EQ(soup.notes.collapsed_faces, collapsed);
    EXPECT_EQ(mentions(soup, "an earlier face and is left out; " + std::to_string(repeated) + " of "),
              repeated > 0 ? 1U : 0U);
    EXPECT_EQ(obj(text, {.keep_repeated = true}).face_count(), good + repeated);
  }
}

TEST(ObjNames, CommentsAreNoPartOfThem) {
  const auto name_of = [](const std::string& line) {
    return obj(square + line + "\nf 1 2 3\n").sections.at(0);
  };
  for (const std::string name :
       {"red", "a b", "Material#1", "Material #25", "#7", "#a", "x#y z", "rot-\xC3\xA4"})
    for (const std::string comment : {"", " # the red one", "\t# x", "   #", " #x", " # a # b", " ## 3 #4"}) {
      EXPECT_EQ(name_of("usemtl " + name + comment).material, name) << name << comment;
      EXPECT_EQ(name_of("g " + name + comment).group, name) << name << comment;
      EXPECT_EQ(name_of("o  " + name + comment).object, name) << name << comment;
    }
  EXPECT_EQ(name_of("usemtl # nothing").material, "");
  EXPECT_EQ(name_of("s off # x").smoothing, "");
  EXPECT_EQ(obj("mtllib m.mtl # materials\n" + square + "f 1 2 3\n").material_libraries,
            std::vector<std::string>{"m.mtl"});
}

// A statement after a line that ends in a backslash is a statement.
TEST(ObjBackslash, DoesNotSwallowTheNextStatement) {
  const std::string faces = "f 1 2 3\nf 1 3 4\n";
  for (const std::string end : {"\n", "\r\n"})
    for (const std::string line : {"usemtl C:\\textures\\", "g a\\", "o a \\", "# C:\\temp\\",
                                   "mtllib a.mtl\\", "s 1 \\", "f 1 2 4 \\", "v 5 5 5\\", "vn 0 0 1 \\"}) {
      const auto soup = obj(square + line + end + faces);
      const std::size_t more = line.front() == 'f' ? 1 : 0;
      EXPECT_EQ(soup.face_count(), 2 + more) << line;
      EXPECT_EQ(obj(square + faces + line).face_count(), 2 + more) << line;
      EXPECT_EQ(obj(square + faces + line + end).face_count(), 2 + more) << line;
    }
  EXPECT_EQ(obj(square + "usemtl textures\\\n" + faces).sections.at(0).material, "textures\\");
  EXPECT_EQ(obj(square + "f 1 2 \\\n3 4\n").face(0).size(), 4U);
  EXPECT_EQ(obj(square + "g a \\\nb \\\nc\n" + faces).sections.at(0).group, "a  b  c");
  EXPECT_EQ(obj(square + "g a \\\nv\n" + faces).sections.at(0).group, "a  v");
}

}  // namespace
}  // namespace multimesh::io::test
