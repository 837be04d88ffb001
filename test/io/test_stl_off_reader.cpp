// SPDX-License-Identifier: BSD-3-Clause
#include <zlib.h>

#include <limits>

#include "adapters/io/gunzip.hpp"
#include "adapters/io/off_reader.hpp"
#include "adapters/io/stl_reader.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/simplex_reader.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

const std::string text_stl =
    "solid a name\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 1 1 -0.0\n"
    "  endloop\n endfacet\n FACET NORMAL 0 0 1\n  outer loop\n   vertex 0 0 -0\n   vertex 1 1 0\n   vertex 0 "
    "1e0 0\n"
    "  endloop\n endfacet\nendsolid a name\n";

std::string binary_stl(std::string header, const std::vector<std::array<float, 9>>& facets) {
  header.resize(80, ' ');
  const auto count = static_cast<std::uint32_t>(facets.size());
  header.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& facet : facets) {
    header.append(12, '\0');
    header.append(reinterpret_cast<const char*>(facet.data()), 36);
    header.append(2, '\0');
  }
  return header;
}

const std::vector<std::array<float, 9>> facets = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}};

TEST(StlReader, EqualCornersAreOnePosition) {
  const std::string solid = "solid but binary";
  for (const std::string& bytes : {text_stl, binary_stl("x", facets), binary_stl(solid, facets)}) {
    const PolygonSoup soup = parse_stl(bytes, "a.stl");
    EXPECT_EQ(soup.face_count(), 2U);
    EXPECT_EQ(soup.positions.size(), 4U);
    EXPECT_EQ(soup.notes.merged_positions, 2U);
    EXPECT_EQ(soup.face(0)[0].v, soup.face(1)[0].v);
    EXPECT_EQ(soup.face(0)[2].v, soup.face(1)[1].v);
  }
}

TEST(StlReader, DegenerateFacetsAreLeftOut) {
  auto with_one = facets;
  with_one.push_back({0, 0, 0, 0, 0, 0, 0, 1, 0});
  const PolygonSoup soup = parse_stl(binary_stl("x", with_one), "a.stl");
  EXPECT_NE(soup.warnings.at(0).find("face 2 (from 0): the face has fewer"), std::string::npos);
  EXPECT_EQ(soup.face_count(), 2U);
  EXPECT_EQ(soup.notes.collapsed_faces, 1U);
}

TEST(StlReader, SolidsAreObjects) {
  const auto solid = [](const std::string& name, int x) {
    const std::string a = "vertex " + std::to_string(x) + " 0 0\n";
    return "solid " + name + "\nfacet normal 0 0 1\nouter loop\n" + a + "vertex 9 0 0\nvertex 0 9 0\n" +
           "endloop\nendfacet\nendsolid " + name + "\n";
  };
  const std::string text = solid("a part ", 1) + solid("", 2) + solid("b", 3);
  const PolygonSoup soup = parse_stl(text, "x.stl");
  std::vector<std::string> objects;
  for (const std::uint32_t s : soup.face_section) objects.push_back(soup.sections[s].object);
  EXPECT_EQ(objects, (std::vector<std::string>{"a part", "", "b"}));
  const SimplexSoup simplices = parse_simplices(text, "x.stl");
  EXPECT_EQ(simplices.simplices[2].tags, (std::vector<std::int32_t>{1, 0, 2}));
  EXPECT_EQ(simplices.groups,
            (std::vector<SimplexSoup::Group>{{2, 1, "a part", "a part"}, {2, 2, "b", "b"}}));
}

TEST(StlReader, TruncatedFilesAreRefused) {
  const std::string binary = binary_stl("x", facets);
  for (std::size_t size = 0; size < binary.size(); ++size)
    EXPECT_NE(error_of([&] { parse_stl(binary.substr(0, size), "a.stl"); }), "") << size;
  const std::size_t last_facet = text_stl.rfind("endfacet") + 8;
  for (std::size_t size = 0; size < last_facet; ++size) {
    // Between two facets nothing tells that there should be more but that endsolid is missing.
    PolygonSoup soup;
    if (error_of([&] { soup = parse_stl(text_stl.substr(0, size), "a.stl"); }).empty()) {
      EXPECT_NE(soup.warnings.at(0).find("without endsolid"), std::string::npos) << size;
    }
  }
  EXPECT_EQ(parse_stl(text_stl.substr(0, last_facet), "a.stl").face_count(), 2U);
  std::string forged = binary;
  forged[83] = '\x7F';
  EXPECT_NE(error_of([&] { parse_stl(forged, "a.stl"); }).find("too few for the 2130706434 facets"),
            std::string::npos);
  EXPECT_EQ(parse_stl(binary + "more", "a.stl").warnings.at(0),
            "a.stl: 4 bytes after the last facet are left out");
}

TEST(StlReader, ErrorsNameTheLineOrTheFace) {
  const auto refusal = [](const std::string& bytes) { return error_of([&] { parse_stl(bytes, "a.stl"); }); };
  std::string text = text_stl;
  EXPECT_NE(refusal(text.replace(text.find("1e0"), 3, "inf")).find("a.stl:13: the corner is not finite"),
            std::string::npos);
  EXPECT_NE(refusal("solid x\nvertex 1 2 3\nendloop\n").find("a.stl:3: the facet has 1 corners"),
            std::string::npos);
  EXPECT_NE(refusal("solid x\nv 1 2 3\n").find("a.stl:2: 'v' is no statement of STL"), std::string::npos);
  EXPECT_NE(refusal("v 1 2 3\n").find("not an STL file"), std::string::npos);
  auto wrong = facets;
  wrong[1][4] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(refusal(binary_stl("x", wrong)).find("face 1 (from 0): a corner is not finite"),
            std::string::npos);
}

PolygonSoup off(const std::string& text) {
  return parse_off(text, "a.off");
}

TEST(OffReader, VariantsCommentsAndPolygons) {
  const PolygonSoup plain =
      off("OFF # comment\n\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0 # four\n4 0 1 2 3\n3 0 1 2 255 0 0\n");
  EXPECT_EQ(plain.face_count(), 2U);
  EXPECT_EQ(plain.face(0).size(), 4U);
  EXPECT_EQ(plain.face_line, (std::vector<std::uint32_t>{8, 9}));
  EXPECT_EQ(plain.warnings.at(0), "a.off: the colours of 1 faces are left out");
  for (const char* colors : {"255 0 51 255", "255 0 51", "1. 0. .2 1.", "1.0 0 0.2"}) {
    const std::string c = colors;
    const PolygonSoup soup = off("COFF\n3 1\n0 0 0 " + c + "\n1 0 0 " + c + "\n0 1 0 " + c + "\n3 0 1 2\n");
    EXPECT_EQ(soup.colors.at(2), (std::array<double, 3>{1, 0, .2})) << c;
  }
  const PolygonSoup all =
      off("STCNOFF 3 1 0\n0 0 0 0 0 1 255 0 0 9 .1 .2\n1 0 0 0 0 1 255 0 0 9 .3 .4\n0 1 0 0 0 1 0 0 255 9 .5 "
          ".6\n3 0 1 2");
  EXPECT_EQ(all.normals.at(2), (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(all.texcoords.at(2), (std::array<double, 2>{.5, .6}));
  EXPECT_EQ(all.colors.at(2), (std::array<double, 3>{0, 0, 1}));
  EXPECT_EQ(all.corners.at(2), (PolygonSoup::Corner{2, 2, 2}));
}

TEST(OffReader, Errors) {
  const auto refusal = [](const std::string& text) { return error_of([&] { off(text); }); };
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_NE(refusal("OFF\n3 1 0\n" + points + "3 0 1 3\n").find("a.off:6: the face names vertex 3"),
            std::string::npos);
  EXPECT_NE(refusal("OFF\n3 1 0\n" + points + "3 0 1\n").find("the file ends before a corner"),
            std::string::npos);
  EXPECT_NE(refusal("OFF\n3 1 0\n" + points + "2 0 1\n").find("the face has 2 corners"), std::string::npos);
  EXPECT_NE(refusal("OFF\n3000000000 1 0\n" + points).find("too short for 3000000000 vertices"),
            std::string::npos);
  EXPECT_NE(refusal("OFF\n3 0 0\n" + points).find("no face"), std::string::npos);
  EXPECT_NE(refusal("OFF BINARY\n").find("binary OFF"), std::string::npos);
  EXPECT_NE(refusal("4OFF\n3 1 0\n").find("other dimensions"), std::string::npos);
  EXPECT_NE(refusal("solid\n").find("not an OFF file"), std::string::npos);
}

/// As gzip would pack it.
std::string packed(const std::string& content) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string bytes(content.size() + 1000, '\0');
  std::string in = content;
  stream.next_in = reinterpret_cast<Bytef*>(in.data());
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_out = static_cast<uInt>(bytes.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  bytes.resize(bytes.size() - stream.avail_out);
  deflateEnd(&stream);
  return bytes;
}

class Gzip : public IoTest {};

TEST_F(Gzip, EveryFormatMayBePacked) {
  std::vector<Form> forms = volume_forms;
  forms.insert(forms.end(), surface_forms.begin(), surface_forms.end());
  for (const Form& form : forms) {
    SCOPED_TRACE(form.name);
    write_simplices(directory / form.name, small_soup(), form.options);
    const SimplexSoup plain = read_simplices(directory / form.name);
    const std::string bytes = packed(content(directory / form.name));
    expect_same_simplices(plain, read_simplices(file(form.name + ".gz", bytes)));
    expect_same_simplices(plain, read_simplices(file("g" + form.name, bytes)));
  }
}

TEST_F(Gzip, MembersFollowOneAnotherAndDamageIsSeen) {
  const std::string text(3000000, 'x');
  const std::string bytes = packed(text) + packed("y");
  EXPECT_EQ(gunzip(bytes, "a.gz"), text + "y");
  for (std::size_t size = 0; size + 1 < packed(text).size(); size += 7)
    EXPECT_NE(error_of([&] { gunzip(packed(text).substr(0, size), "a.gz"); }).find("a.gz: the gzip data is"),
              std::string::npos);
  std::string damaged = bytes;
  damaged[15] = static_cast<char>(damaged[15] ^ 0x55);
  EXPECT_NE(error_of([&] { gunzip(damaged, "a.gz"); }), "");
}

}  // namespace
}  // namespace multimesh::io::test
