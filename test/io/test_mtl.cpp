// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/mtl.hpp"
#include "adapters/io/mtl_rewrite.hpp"
#include "io_fixture.hpp"

namespace multimesh::io::test {
namespace {

using Names = std::vector<std::string>;

TEST(MtlRewrite, OnlyTexturePathsChange) {
  const auto mark = [](std::string_view path) { return std::string("<").append(path).append(">"); };
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"newmtl a b\n", "newmtl a b\n"},
      {"# map_Kd a.png\n", "# map_Kd a.png\n"},
      {"map_Kd a.png", "map_Kd <a.png>"},
      {"\tmap_Kd  fuze uv.jpg \r\n", "\tmap_Kd  <fuze uv.jpg> \r\n"},
      {"map_Kd -s 1 1 1 -o 0 0 a b.png\n", "map_Kd -s 1 1 1 -o 0 0 <a b.png>\n"},
      {"bump -bm 0.5 1.png\n", "bump -bm 0.5 <1.png>\n"},
      {"map_Bump -bm 2 -clamp on n.png\n", "map_Bump -bm 2 -clamp on <n.png>\n"},
      {"map_Kd -t 0.5 1 2\n", "map_Kd -t 0.5 1 <2>\n"},
      {"map_Kd -mm 0 1 01_-_x.JPG\n", "map_Kd -mm 0 1 <01_-_x.JPG>\n"},
      {"map_Kd -my texture-.png\n", "map_Kd <-my texture-.png>\n"},
      {"map_Kd a b.png -s 1 1 1 -clamp on\n", "map_Kd <a b.png> -s 1 1 1 -clamp on\n"},
      {"map_Kd -bm 1 \"a b.png\" -s 1\n", "map_Kd -bm 1 \"<a b.png>\" -s 1\n"},
      {"map_Kd a -b c.png\n", "map_Kd <a -b c.png>\n"},
      {"refl -type sphere env.png\n", "refl -type sphere <env.png>\n"},
      {"disp d\ndecal e\nnorm f\nmap_Pr g\n", "disp <d>\ndecal <e>\nnorm <f>\nmap_Pr <g>\n"},
      {"map_aat on\nmap_Kd\nKd 1 1 1\n\n", "map_aat on\nmap_Kd\nKd 1 1 1\n\n"}};
  for (const auto& [text, expected] : cases) EXPECT_EQ(rewrite_textures(text, mark), expected);
}

class Mtl : public IoTest {
 protected:
  Names relocate(const Names& libraries, const std::string& input, const std::string& output) {
    return relocate_material_libraries(libraries, directory / input, directory / output, warnings);
  }
  Names warnings;
};

TEST_F(Mtl, InTheSameDirectoryNothingHappens) {
  file("a.mtl", "map_Kd t.png\n");
  fs::create_directory(directory / "x");
  EXPECT_EQ(relocate({"a.mtl", "gone.mtl"}, "in.obj", "./x/../out.obj"), (Names{"a.mtl", "gone.mtl"}));
  EXPECT_EQ(names_in(directory), (Names{"a.mtl", "x"}));
}

TEST_F(Mtl, ACopyLeadsToTheSameImages) {
  file("in/a.mtl",
       "map_Kd -s 1 1 1 tex/my wood.png\r\nmap_Ks ../up.png\nmap_Kd /abs/x.png\nmap_Kd C:\\x.png\n");
  fs::create_directories(directory / "out/deep");
  EXPECT_EQ(relocate({"a.mtl"}, "in/m.obj", "out/deep/m.obj"), Names{"a.mtl"});
  EXPECT_EQ(content(directory / "out/deep/a.mtl"),
            "map_Kd -s 1 1 1 ../../in/tex/my wood.png\r\nmap_Ks ../../up.png\nmap_Kd /abs/x.png\nmap_Kd "
            "C:\\x.png\n");
  EXPECT_EQ(names_in(directory / "out/deep"), Names{"a.mtl"});
}

TEST_F(Mtl, TexturesBesideTheObjAndWithBackslashesAreFound) {
  file("in/lib/a.mtl", "map_Kd t.png\nmap_Kd sub\\u.png\n");
  file("in/t.png", "");
  file("in/lib/sub/u.png", "");
  fs::create_directories(directory / "out");
  EXPECT_EQ(relocate({"lib\\a.mtl"}, "in/m.obj", "out/m.obj"), Names{"a.mtl"});
  EXPECT_EQ(content(directory / "out/a.mtl"), "map_Kd ../in/t.png\nmap_Kd ../in/lib/sub/u.png\n");
}

TEST_F(Mtl, AnotherFileOfTheNameIsLeftAlone) {
  file("in/a.mtl", "Kd 1 1 1\n");
  file("out/a.mtl", "someone's\n");
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(relocate({"a.mtl"}, "in/m.obj", "out/result.obj"), Names{"result.mtl"});
    EXPECT_EQ(content(directory / "out/a.mtl"), "someone's\n");
    EXPECT_EQ(content(directory / "out/result.mtl"), "Kd 1 1 1\n");
    EXPECT_EQ(names_in(directory / "out"), (Names{"a.mtl", "result.mtl"}));
  }
  EXPECT_EQ(warnings.size(), 2U);
}

TEST_F(Mtl, TwoLibrariesOfOneNameStayTwo) {
  file("in/x/a.mtl", "Kd 1 1 1\n");
  file("in/y/a.mtl", "Kd 0 0 0\n");
  fs::create_directories(directory / "out");
  EXPECT_EQ(relocate({"x/a.mtl", "y/a.mtl"}, "in/m.obj", "out/r.obj"), (Names{"a.mtl", "r.mtl"}));
}

TEST_F(Mtl, TheLibraryOfTheInputIsNeverWrittenTo) {
  file("out/a.mtl", "map_Kd t.png\n");
  fs::create_directories(directory / "in");
  EXPECT_EQ(relocate({"../out/a.mtl"}, "in/m.obj", "out/m.obj"), Names{"a.mtl"});
  EXPECT_EQ(content(directory / "out/a.mtl"), "map_Kd t.png\n");
}

TEST_F(Mtl, MissingLibrariesKeepTheirNameAndWarn) {
  fs::create_directories(directory / "in");
  fs::create_directories(directory / "out");
  EXPECT_EQ(relocate({"gone.mtl"}, "in/m.obj", "out/m.obj"), Names{"gone.mtl"});
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("'gone.mtl' was not found"), std::string::npos);
}

}  // namespace
}  // namespace multimesh::io::test
