// SPDX-License-Identifier: BSD-3-Clause
// Materials and groups face by face; material libraries and textures relative to the output.
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include "multimesh/io/obj_reader.hpp"
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

using io::PolygonSoup;

class Materials : public ProgramTest {
 protected:
  PolygonSoup read(const std::string& name) const { return io::read_obj(directory / name, {1, 1}); }
  /// Where a texture path of an MTL file leads.
  fs::path texture_of(const std::string& mtl) const {
    std::istringstream lines(content(mtl));
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with("map_Kd ")) return (directory / mtl).parent_path() / line.substr(7);
    return {};
  }
};

struct Part {
  double area = 0, low = 1e300, high = -1e300;
  std::set<std::string> groups;
};

/// Area and extent in x per material.
std::map<std::string, Part> parts(const PolygonSoup& s) {
  std::map<std::string, Part> result;
  for (std::size_t f = 0; f < s.face_count(); ++f) {
    const auto& section = s.sections[s.face_section[f]];
    Part& part = result[section.material];
    part.groups.insert(section.group);
    const auto at = [&](std::size_t i) { return s.positions[static_cast<std::size_t>(s.face(f)[i].v)]; };
    const auto a = at(0), b = at(1), c = at(2);
    part.area += ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    for (const auto& p : {a, b, c})
      part.low = std::min(part.low, p[0]), part.high = std::max(part.high, p[0]);
  }
  return result;
}

TEST_F(Materials, StayOnTheirSideOfASeam) {
  file("in.obj", grid_obj(30));
  for (const char* cost : {"quadric", "length"})
    for (const char* ratio : {"1", "0.5", "0.1", "0.02"}) {
      SCOPED_TRACE(std::string(cost) + " " + ratio);
      ASSERT_EQ(decimate("in.obj", "out.obj", {"--ratio", ratio, "--cost", cost}).status, 0);
      const auto found = parts(read("out.obj"));
      ASSERT_EQ(found.size(), 2U);
      // The best place of a vertex on a straight seam is on it, up to how exactly it is solved for.
      constexpr double rounding = 1e-6;
      EXPECT_GE(found.at("left").low, -rounding);
      EXPECT_NEAR(found.at("left").high, 15, rounding);
      EXPECT_NEAR(found.at("right").low, 15, rounding);
      EXPECT_LE(found.at("right").high, 30 + rounding);
      EXPECT_EQ(found.at("left").groups, std::set<std::string>{"left"});
      EXPECT_EQ(found.at("right").groups, std::set<std::string>{"right"});
    }
}

TEST_F(Materials, WithoutASeamEachFaceStillHasThatOfItsPlace) {
  file("in.obj", grid_obj(30, false));
  for (const char* ratio : {"0.5", "0.1"}) {
    ASSERT_EQ(decimate("in.obj", "out.obj", {"--ratio", ratio}).status, 0);
    const auto found = parts(read("out.obj"));
    ASSERT_EQ(found.size(), 2U) << ratio;
    EXPECT_LT(found.at("left").low, 15);
    EXPECT_GT(found.at("right").high, 15);
    EXPECT_GT(found.at("left").area, 0);
    EXPECT_GT(found.at("right").area, 0);
  }
}

TEST_F(Materials, EveryFaceOfTheInputKeepsItsOwnAtRatioOne) {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\n";
  file("in.obj",
       head + "o first\ng a b\nusemtl red\nf 1 2 3 4\nusemtl blue\nf 2 5 6\no second\ng c\nf 2 6 3\n");
  ASSERT_EQ(decimate("in.obj", "out.obj", {"--ratio", "1"}).status, 0);
  const PolygonSoup s = read("out.obj");
  std::vector<std::string> found;
  for (const auto section : s.face_section) {
    const auto& x = s.sections[section];
    found.push_back(x.object + "|" + x.group + "|" + x.material);
  }
  EXPECT_EQ(found,
            (std::vector<std::string>{"first|a b|red", "first|a b|red", "first|a b|blue", "second|c|blue"}));
}

constexpr const char* library = "newmtl left\nKd 1 0 0\nmap_Kd tex/cow skin.png\nnewmtl right\nKd 0 0 1\n";

TEST_F(Materials, LibraryAndTextureAreFoundFromAnotherDirectory) {
  file("in/a.obj", grid_obj(8, true, "mtllib my materials.mtl\n"));
  file("in/my materials.mtl", library);
  file("in/tex/cow skin.png", "png");
  fs::create_directories(directory / "out/deep");
  for (const std::string out : {"out", "out/deep"}) {
    ASSERT_EQ(decimate("in/a.obj", out + "/b.obj", {"--ratio", "0.5"}).status, 0);
    EXPECT_EQ(read(out + "/b.obj").material_libraries, std::vector<std::string>{"my materials.mtl"});
    ASSERT_TRUE(exists(out + "/my materials.mtl"));
    EXPECT_EQ(fs::canonical(texture_of(out + "/my materials.mtl")),
              fs::canonical(directory / "in/tex/cow skin.png"));
  }
  EXPECT_EQ(content("in/my materials.mtl"), library) << "the input's own is not touched";
}

TEST_F(Materials, NextToTheInputTheLibraryIsShared) {
  file("a.obj", grid_obj(8, true, "mtllib m.mtl\n"));
  file("m.mtl", library);
  ASSERT_EQ(decimate("a.obj", "b.obj", {"--ratio", "0.5"}).status, 0);
  EXPECT_EQ(names(), (std::vector<std::string>{"a.obj", "b.obj", "m.mtl"}));
  EXPECT_EQ(content("m.mtl"), library);
}

TEST_F(Materials, AnotherLibraryOfThatNameIsNotOverwritten) {
  file("in/a.obj", grid_obj(8, true, "mtllib m.mtl\n"));
  file("in/m.mtl", library);
  file("out/m.mtl", "newmtl someone else's\n");
  ASSERT_EQ(decimate("in/a.obj", "out/b.obj", {"--ratio", "0.5"}).status, 0);
  EXPECT_EQ(content("out/m.mtl"), "newmtl someone else's\n");
  const auto libraries = read("out/b.obj").material_libraries;
  ASSERT_EQ(libraries.size(), 1U);
  EXPECT_TRUE(exists("out/" + libraries[0])) << libraries[0];
}

TEST_F(Materials, AMissingLibraryIsAWarning) {
  file("in/a.obj", grid_obj(8, true, "mtllib gone.mtl\n"));
  fs::create_directory(directory / "out");
  const Ended e = decimate("in/a.obj", "out/b.obj", {"--ratio", "0.5"});
  EXPECT_EQ(e.status, 0);
  EXPECT_TRUE(contains(e.err, "warning: ") && contains(e.err, "gone.mtl")) << e.err;
}

TEST_F(Materials, FilesOutsideOfTheInputsDirectoryAreReadOnRequestOnly) {
  const std::string png = "\x89PNG\r\n\x1a\n SECRET PIXELS";
  file("in/a.obj", grid_obj(8, true, "mtllib ../secret/passwd own.mtl\n"));
  file("in/own.mtl", "newmtl left\nmap_Kd ../secret/image.png\nnewmtl right\nmap_Kd ../secret/text.png\n");
  file("secret/passwd", "TOP SECRET token=123\n");
  file("secret/image.png", png);
  file("secret/text.png", "TOP SECRET token=123\n");
  fs::create_directory(directory / "out");
  for (const bool follow : {false, true}) {
    Arguments more = {"--ratio", "0.5", "--report-html", "out/page.html", "--report", "out/report.json"};
    if (follow) more.emplace_back("--follow-paths");
    const Ended e = decimate("in/a.obj", "out/b.obj", more);
    ASSERT_EQ(e.status, 0) << e.err;
    for (const std::string& name : names("out"))
      EXPECT_FALSE(contains(content("out/" + name), "TOP SECRET")) << name;
    EXPECT_TRUE(contains(e.err, "warning: ") && contains(e.err, "../secret/passwd")) << e.err;
    EXPECT_EQ(contains(e.err, "--follow-paths"), !follow) << e.err;
    EXPECT_EQ(contains(content("out/page.html"), "data:image/png"), follow);
    for (const auto& w : json("out/report.json")["warnings"])
      EXPECT_TRUE(contains(e.err, w.get<std::string>())) << w;
  }
}

TEST_F(Materials, WhatAPageCannotShowIsOneWarning) {
  file("in/a.obj", grid_obj(8, true, "mtllib own.mtl\n"));
  file("in/own.mtl",
       "newmtl left\nmap_Kd C:\\tex\\Skin.png\nnewmtl right\nmap_Kd C:\\tex\\no.png -s 1 1 1\n");
  file("in/skin.PNG", "\x89PNG\r\n\x1a\n");
  fs::create_directories(directory / "out");
  for (const std::string out : {"in/b.obj", "out/b.obj"}) {
    const Ended e = decimate("in/a.obj", out, {"--ratio", "0.5", "--report-html", "p.html"});
    ASSERT_EQ(e.status, 0) << e.err;
    std::size_t warnings = 0;
    for (std::size_t at = e.err.find("warning"); at != std::string::npos; at = e.err.find("warning", at + 1))
      ++warnings;
    EXPECT_EQ(warnings, 1U) << e.err;
    EXPECT_TRUE(contains(e.err, "C:\\tex\\no.png")) << e.err;
    EXPECT_TRUE(contains(content("p.html"), "data:image/png"));
  }
  EXPECT_EQ(fs::canonical(texture_of("out/own.mtl")), fs::canonical(directory / "in/skin.PNG"));
}

/// The grid as PLY, with a texture image for each half; corners on their border have equal texture
/// coordinates.
std::string paged_grid_ply(int n) {
  std::ostringstream out;
  out << "ply\nformat ascii 1.0\ncomment TextureFile left.png\ncomment TextureFile right.png\nelement vertex "
      << (n + 1) * (n + 1) << "\nproperty float x\nproperty float y\nproperty float z\nelement face "
      << 2 * n * n
      << "\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nproperty int "
         "texnumber\n"
         "end_header\n";
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) out << i << ' ' << j << " 0\n";
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (const auto& t : {std::array{0, 0, 1, 0, 1, 1}, std::array{0, 0, 1, 1, 0, 1}}) {
        out << 3;
        for (std::size_t c = 0; c < 6; c += 2) out << ' ' << (i + t[c]) * (n + 1) + j + t[c + 1];
        out << " 6";
        for (std::size_t c = 0; c < 6; ++c) out << ' ' << (c % 2 == 0 ? i + t[c] : j + t[c]) / double(n);
        out << ' ' << (2 * i >= n) << '\n';
      }
  return out.str();
}

TEST_F(Materials, TexturePagesOfPlyFilesAreMaterials) {
  file("in/a.ply", paged_grid_ply(30));
  file("in/left.png", "\x89PNG\r\n\x1a\n");
  file("in/right.png", "\x89PNG\r\n\x1a\n");
  fs::create_directories(directory / "out");
  for (const std::string out : {"in", "out"})
    for (const Arguments& more : {Arguments{"--ratio", "0.1"}, Arguments{"--ratio", "0.02"}}) {
      const Ended e = decimate("in/a.ply", out + "/b.obj", more);
      ASSERT_EQ(e.status, 0) << e.err;
      EXPECT_FALSE(contains(e.err, "warning")) << e.err;
      const PolygonSoup s = read(out + "/b.obj");
      const auto found = parts(s);
      ASSERT_EQ(found.size(), 2U);
      EXPECT_NEAR(found.at("left").high, 15, 1e-6) << "no face crosses the border of the pages";
      EXPECT_NEAR(found.at("right").low, 15, 1e-6);
      EXPECT_NEAR(found.at("left").area, 450, 1e-3);
      ASSERT_EQ(s.material_libraries, std::vector<std::string>{"b.mtl"});
      EXPECT_EQ(fs::canonical(texture_of(out + "/b.mtl")), fs::canonical(directory / "in/left.png"));
    }
  ASSERT_EQ(decimate("in/a.ply", "out/b.obj", {"--ratio", "0.5", "--report-html", "p.html"}).status, 0);
  EXPECT_TRUE(contains(content("p.html"), "right.png"));
}

}  // namespace
}  // namespace multimesh::tools::test
