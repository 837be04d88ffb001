// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstring>
#include <set>

#include "adapters/io/ply_reader.hpp"
#include "io_fixture.hpp"

namespace multimesh::io::test {
namespace {

class PlyReader : public IoTest {
 protected:
  PolygonSoup read(const std::string& bytes) const { return read_ply(file("a.ply", bytes)); }
  std::string refusal(const std::string& bytes) const {
    return error_of([&] { read(bytes); });
  }
};

std::string header(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty double y\nproperty short z\nproperty "
         "uchar red\n"
         "property uchar green\nproperty uchar blue\nelement skipped 2\nproperty list uint8 uint16 "
         "a\nelement face 2\n"
         "property int flags\nproperty list uchar int vertex_indices\nproperty list uchar float "
         "texcoord\nend_header\n";
}

const std::string ascii = header("ascii") +
                          "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1.5 0 0 0 255\n0 1 -7 51 51 51\n\n2 7 8\n0\n"
                          "9 3 0 1 2 6 0 0 1 0 1 1\n9 3 0 2 3 6 0 0 .5 1 0 1\n";

/// The same mesh in binary.
class BinaryPly {
 public:
  explicit BinaryPly(bool big)
      : big_(big), bytes_(header(big ? "binary_big_endian" : "binary_little_endian")) {}

  std::string make() {
    const double positions[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1.5, 0}, {0, 1, -7}};
    const int colors[4][3] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {51, 51, 51}};
    for (int v = 0; v < 4; ++v) {
      put(static_cast<float>(positions[v][0]));
      put(positions[v][1]);
      put(static_cast<std::int16_t>(positions[v][2]));
      for (const int c : colors[v]) put(static_cast<std::uint8_t>(c));
    }
    put(std::uint8_t{2});
    put(std::uint16_t{7});
    put(std::uint16_t{8});
    put(std::uint8_t{0});
    face({0, 1, 2}, {0, 0, 1, 0, 1, 1});
    face({0, 2, 3}, {0, 0, .5F, 1, 0, 1});
    return bytes_;
  }

 private:
  void face(const std::vector<std::int32_t>& vertices, const std::vector<float>& texcoords) {
    put(std::int32_t{9});
    put(static_cast<std::uint8_t>(vertices.size()));
    for (const auto v : vertices) put(v);
    put(static_cast<std::uint8_t>(texcoords.size()));
    for (const auto t : texcoords) put(t);
  }
  template <class T>
  void put(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (big_) std::reverse(raw, raw + sizeof(T));
    bytes_.append(raw, sizeof(T));
  }
  bool big_;
  std::string bytes_;
};

TEST_F(PlyReader, TheThreeFormatsAgree) {
  const PolygonSoup text = read(ascii);
  ASSERT_EQ(text.face_count(), 2U);
  EXPECT_EQ(text.positions[3], (std::array<double, 3>{0, 1, -7}));
  EXPECT_EQ(text.colors[3], (std::array<double, 3>{.2, .2, .2}));
  for (const bool big : {false, true}) {
    const PolygonSoup binary = read(BinaryPly(big).make());
    EXPECT_EQ(binary.positions, text.positions);
    EXPECT_EQ(binary.colors, text.colors);
    EXPECT_EQ(binary.texcoords, text.texcoords);
    EXPECT_EQ(binary.corners, text.corners);
  }
}

TEST_F(PlyReader, EqualWedgesAtAVertexAreOneTexcoord) {
  const PolygonSoup soup = read(ascii);
  EXPECT_EQ(soup.face(0)[0], soup.face(1)[0]);
  EXPECT_EQ(soup.face(0)[2].v, soup.face(1)[1].v);
  EXPECT_NE(soup.face(0)[2].vt, soup.face(1)[1].vt);
  EXPECT_EQ(soup.texcoords.size(), 5U);
}

TEST_F(PlyReader, TexcoordsPerVertex) {
  for (const auto& [s, t] : {std::pair("s", "t"), std::pair("u", "v"), std::pair("texture_u", "texture_v")}) {
    const auto soup = read(
        std::string("ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
                    "property float z\r\nproperty float ") +
        s + "\r\nproperty float " + t +
        "\r\nelement face 1\r\nproperty list uchar uint vertex_index\r\nend_header\r\n0 0 0 .1 .2\r\n"
        "1 0 0 .3 .4\r\n0 1 0 .5 .6\r\n3 0 1 2\r\n");
    ASSERT_EQ(soup.texcoords.size(), 3U);
    EXPECT_EQ(soup.texcoords[1], (std::array<double, 2>{.3, .4}));
    for (const auto& c : soup.corners) EXPECT_EQ(c.v, c.vt);
  }
}

TEST_F(PlyReader, TruncatedAnywhereIsRefused) {
  for (const std::string& bytes : {ascii, BinaryPly(false).make(), BinaryPly(true).make()}) {
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      PolygonSoup soup;
      const std::string error = error_of([&] { soup = parse_ply(bytes.substr(0, size), "a.ply"); });
      // The ASCII file may lose the end of its last line, and that line the digits of its last number: not
      // seen.
      if (error.empty())
        EXPECT_EQ(soup.face_count(), 2U) << size;
      else
        EXPECT_NE(error.find("a.ply:"), std::string::npos) << error;
      const bool binary = bytes.find("binary") != std::string::npos;
      EXPECT_TRUE(!binary || !error.empty()) << size;
    }
  }
}

TEST_F(PlyReader, DamagedBytesNeverCrash) {
  for (const std::string& bytes : {ascii, BinaryPly(false).make()})
    for (std::size_t i = 0; i < bytes.size(); ++i)
      for (const char c : {'\0', '\xFF', '9', ' ', '\n', '-'}) {
        std::string damaged = bytes;
        damaged[i] = c;
        PolygonSoup soup;
        if (!error_of([&] { soup = parse_ply(damaged, directory / "d.ply"); }).empty()) continue;
        for (const auto& corner : soup.corners)
          ASSERT_TRUE(corner.v >= 0 && corner.v < static_cast<int>(soup.positions.size())) << i;
      }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST_F(PlyReader, ErrorsNameTheLineOrTheElement) {
  EXPECT_NE(refusal(replaced(ascii, "9 3 0 2 3", "9 3 0 2 4"))
                .find("a.ply:26: the face names vertex 4 but the file has 4"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "9 3 0 2 3", "9 3 0 2 -1")).find("a.ply:26: corner 2"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "1 1.5 0", "1 nan 0")).find("a.ply:20: the vertex is not finite"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "1 1.5 0", "1 1.5")).find("a.ply:20: the line has fewer"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "1 1.5 0", "1 1.5 0 0")).find("a.ply:20: the line has more"),
            std::string::npos);
  EXPECT_NE(
      refusal(replaced(ascii, "6 0 0 1 0 1 1", "4 0 0 1 0")).find("a.ply:25: the face has 3 corners and 4"),
      std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "property double y", "property real y"))
                .find("a.ply:6: unknown PLY type 'real'"),
            std::string::npos);
  EXPECT_NE(refusal(replaced(ascii, "property double y", "property double w"))
                .find("a.ply:4: the vertices have no"),
            std::string::npos);
  std::string binary = BinaryPly(false).make();
  binary.resize(binary.size() - 3);
  EXPECT_NE(refusal(binary).find("a.ply: the file ends in or before face 1 (from 0) of 2"), std::string::npos)
      << refusal(binary);
}

TEST_F(PlyReader, SculptHasAWedgeTexcoordOnEveryCorner) {
  const fs::path root = shared("textured");
  if (root.empty()) GTEST_SKIP() << "no shared data";
  const PolygonSoup soup = read_ply(root / "sculpt_ply" / "sculpt.ply");
  std::set<std::pair<std::int32_t, std::array<double, 2>>> wedges;
  for (const auto& c : soup.corners) {
    ASSERT_GE(c.vt, 0);
    wedges.emplace(c.v, soup.texcoords[static_cast<std::size_t>(c.vt)]);
  }
  EXPECT_EQ(wedges.size(), soup.texcoords.size());
}

constexpr const char* two_pages =
    "ply\nformat ascii 1.0\ncomment TextureFile tex/page 0.png\ncomment TextureFile page1.png\n"
    "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n%s"
    "element face 3\nproperty list uchar int vertex_indices\n%sproperty int texnumber\nend_header\n%s";

std::string two_pages_with(const std::string& vertex, const std::string& face, const std::string& body) {
  std::string text = two_pages;
  for (const std::string& part : {vertex, face, body}) text.replace(text.find("%s"), 2, part);
  return text;
}

void expect_pages(const PolygonSoup& s) {
  ASSERT_EQ(s.face_count(), 3U);
  ASSERT_EQ(s.materials.size(), 2U);
  EXPECT_EQ(s.materials[0].name, "page_0");
  EXPECT_EQ(s.materials[0].texture, "tex/page 0.png");
  EXPECT_EQ(s.materials[1].name, "page1");
  EXPECT_TRUE(s.warnings.empty()) << s.warnings[0];
  for (std::size_t f = 0; f < 3; ++f)
    EXPECT_EQ(s.sections[s.face_section[f]].material, f == 1 ? "page1" : "page_0");
}

TEST_F(PlyReader, TexturePagesAreMaterials) {
  expect_pages(read_ply(file("corner.ply", two_pages_with("", "property list uchar float texcoord\n",
                                                          "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n"
                                                          "3 0 1 2 6 0 0 1 0 1 1 0\n"
                                                          "3 0 2 3 6 0 0 1 1 0 1 1\n"
                                                          "3 3 2 4 6 0 1 1 1 0 2 0\n"))));
  expect_pages(
      read_ply(file("vertex.ply", two_pages_with("property float s\nproperty float t\n", "",
                                                 "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n0 2 0 0 2\n"
                                                 "3 0 1 2 0\n3 0 2 3 1\n3 3 2 4 0\n"))));
}

TEST_F(PlyReader, TextureNumbersWithoutImagesAreMaterialsToo) {
  std::string text = two_pages_with("", "property list uchar float texcoord\n",
                                    "0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 2 0\n3 0 1 2 6 0 0 1 0 1 1 -1\n"
                                    "3 0 2 3 6 0 0 1 1 0 1 7\n3 3 2 4 6 0 1 1 1 0 2 1\n");
  const PolygonSoup s = read_ply(file("a.ply", text));
  std::vector<std::string> found;
  for (const auto section : s.face_section) found.push_back(s.sections[section].material);
  EXPECT_EQ(found, (std::vector<std::string>{"", "page_7", "page1"}));
  EXPECT_EQ(s.materials[0].texture, "");
}

TEST_F(PlyReader, OneTextureImageIsOfAllFaces) {
  const PolygonSoup s = read_ply(
      file("a.ply",
           "ply\nformat ascii 1.0\ncomment TextureFile a.b.png\nelement vertex 3\nproperty float x\n"
           "property float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
           "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"));
  ASSERT_EQ(s.materials.size(), 1U);
  EXPECT_EQ(s.sections[s.face_section[0]].material, "a.b");
}

}  // namespace
}  // namespace multimesh::io::test
