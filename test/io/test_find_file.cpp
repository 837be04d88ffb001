// SPDX-License-Identifier: BSD-3-Clause
// Files that a file names: found under the names that other programs and machines write, and only where this
// is allowed.
#include "adapters/io/find_file.hpp"
#include "adapters/io/mtl.hpp"
#include "io_fixture.hpp"

namespace multimesh::io::test {
namespace {

class FindFile : public IoTest {
 protected:
  FoundFile find(const std::string& name, bool anywhere = false) const {
    return find_file(name, search_beside(directory / "in/mesh.obj", anywhere));
  }
  /// Relative to the directory of the mesh; empty: not found or outside.
  std::string found(const std::string& name) const {
    const FoundFile f = find(name);
    return f.outside || f.path.empty() ? "" : f.path.lexically_relative(directory / "in").generic_string();
  }
};

TEST_F(FindFile, AsOtherMachinesWriteTheName) {
  file("in/Skin.PNG", "");
  file("in/tex/my wood.png", "");
  for (const std::string name :
       {"Skin.PNG", "skin.png", "./SKIN.png", "C:\\Users\\me\\skin.png", "\\\\server\\share\\Skin.PNG",
        "/home/me/skin.png", "../elsewhere/skin.png", "textures/skin.png", "file:///c:/x/skin.png"})
    EXPECT_EQ(find(name).path.filename(), "Skin.PNG") << name;
  for (const std::string name :
       {"tex/my wood.png", "tex\\my wood.png", "TEX\\My Wood.png", "tex/../tex/my wood.png"})
    EXPECT_EQ(find(name).path.filename(), "my wood.png") << name;
  for (const std::string name : {"", ".", "..", "tex", "no.png", "my wood.png", "Skin.PNG/x"})
    EXPECT_EQ(found(name), "") << name;
}

TEST_F(FindFile, TheWrittenCaseIsPreferred) {
  file("in/a.png", "");
  file("in/A.png", "");
  EXPECT_EQ(found("a.png"), "a.png");
  EXPECT_EQ(found("A.png"), "A.png");
}

TEST_F(FindFile, TheFirstTileOfSeveral) {
  file("in/skin.1002.png", "");
  file("in/skin.1001.png", "");
  file("in/skin.10012.png", "");
  file("in/skin.bad1.png", "");
  EXPECT_EQ(found("skin.<UDIM>.png"), "skin.1001.png");
  EXPECT_EQ(found("D:\\x\\Skin.<udim>.PNG"), "skin.1001.png");
  EXPECT_EQ(found("other.<UDIM>.png"), "");
}

/// All spellings of one file outside that a file could use, links included.
class Spellings : public FindFile {
 protected:
  void SetUp() override {
    FindFile::SetUp();
    const fs::path outside = file("secret/x.mtl", secret);
    file("in/deep/er/a.txt", "");
    fs::create_symlink(outside, directory / "in/link.mtl");
    fs::create_symlink("../secret", directory / "in/linked");
    fs::create_symlink("../../../secret/x.mtl", directory / "in/deep/er/link.mtl");
    fs::create_directories(directory / "out");
    names = {"../secret/x.mtl",
             "./../secret/x.mtl",
             "deep/../../secret/x.mtl",
             "deep/er/../../../secret/x.mtl",
             "..\\secret\\x.mtl",
             "deep\\..\\..\\secret\\x.mtl",
             "..//secret/./x.mtl",
             "../SECRET/X.mtl",
             "../in/../secret/x.mtl",
             "link.mtl",
             "LINK.MTL",
             "linked/x.mtl",
             "deep/er/link.mtl",
             "linked/../secret/x.mtl",
             outside.string(),
             "/.." + outside.string(),
             "../secret/<UDIM>.mtl"};
    file("secret/1001.mtl", secret);
  }
  const std::string secret = "newmtl s\nKd 1 1 1\nTOKEN 123\n";
  std::vector<std::string> names;
};

TEST_F(Spellings, OutsideIsToldAndNotFollowed) {
  for (const std::string& name : names) {
    const FoundFile found = find(name);
    EXPECT_TRUE(found.outside) << name;
    EXPECT_FALSE(find(name, true).path.empty()) << name;
    EXPECT_FALSE(find(name, true).outside) << name;
  }
}

TEST_F(Spellings, NothingOfItGetsIntoTheOutputDirectory) {
  for (const std::string& name : names) {
    std::vector<std::string> warnings;
    EXPECT_EQ(
        relocate_material_libraries({name}, directory / "in/mesh.obj", directory / "out/mesh.obj", warnings),
        std::vector<std::string>{name});
    EXPECT_TRUE(fs::is_empty(directory / "out")) << name;
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].find(name), std::string::npos);
    EXPECT_NE(warnings[0].find("--follow-paths"), std::string::npos);
  }
}

TEST_F(Spellings, FollowedOnlyTheMtlOfAFileIsCopied) {
  std::vector<std::string> warnings;
  ASSERT_EQ(relocate_material_libraries({names[0]}, directory / "in/mesh.obj", directory / "out/mesh.obj",
                                        warnings, true),
            std::vector<std::string>{"x.mtl"});
  EXPECT_EQ(content(directory / "out/x.mtl"), "newmtl s\nKd 1 1 1\n");
  ASSERT_EQ(warnings.size(), 1U) << "of the line that is left out";
}

TEST_F(FindFile, WhatIsNoMtlIsNotCopiedWhateverItsName) {
  const std::vector<std::string> others = {"",
                                           "# password: 123\n",
                                           "TOP SECRET token=123\n",
                                           "root:x:0:0:root:/root:/bin/bash\n",
                                           "-----BEGIN PRIVATE KEY-----\nMIIEvQ\n-----END PRIVATE KEY-----\n",
                                           "{\"newmtl\": 1}\n",
                                           "a = 1\nb = 2\nnewmtl x\n",
                                           "d hidden\nKd secret\n",
                                           std::string("\x89PNG\r\n\x1a\n\0newmtl a\n", 18),
                                           "v 0 0 0\nv 1 0 0\nf 1 2 3\nusemtl x\n"};
  fs::create_directories(directory / "out");
  for (const std::string& text : others) {
    file("in/a.mtl", text);
    std::vector<std::string> warnings;
    EXPECT_EQ(relocate_material_libraries({"a.mtl"}, directory / "in/m.obj", directory / "out/m.obj",
                                          warnings, true),
              std::vector<std::string>{"a.mtl"});
    EXPECT_TRUE(fs::is_empty(directory / "out")) << text;
    EXPECT_EQ(warnings.size(), 1U) << text;
  }
}

TEST_F(FindFile, TexturesOfAnotherMachineAreFoundBesideTheCopy) {
  file("in/Wood.PNG", "");
  file("in/skin.1001.png", "");
  file("in/a.mtl",
       "newmtl a\nmap_Kd D:\\work\\wood.png -s 1 1 1\nmap_Ks no.png\nmap_Kd \"wood.png\"\nbump -bm 1 "
       "x\\no.png\n"
       "map_Kd Skin.<UDIM>.png\nmap_Kd /mnt/c/wood.png\n");
  fs::create_directories(directory / "out");
  std::vector<std::string> warnings;
  relocate_material_libraries({"a.mtl"}, directory / "in/m.obj", directory / "out/m.obj", warnings);
  EXPECT_EQ(content(directory / "out/a.mtl"),
            "newmtl a\nmap_Kd ../in/Wood.PNG -s 1 1 1\nmap_Ks ../in/no.png\nmap_Kd \"../in/Wood.PNG\"\n"
            "bump -bm 1 ../in/x\\no.png\nmap_Kd ../in/Skin.<UDIM>.png\nmap_Kd ../in/Wood.PNG\n");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("'no.png', 'x\\no.png'"), std::string::npos) << warnings[0];
}

}  // namespace
}  // namespace multimesh::io::test
