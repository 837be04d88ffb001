// SPDX-License-Identifier: BSD-3-Clause
// The messages of read_mesh on every file that is wrong on purpose, on what is not a file, and on good ones.
#include <map>

#include "io_fixture.hpp"
#include "multimesh/io/mesh_reader.hpp"

namespace multimesh::io::test {
namespace {

struct Verdict {
  std::string message;  ///< a part of it; empty = the file is read
};

const std::map<std::string, Verdict> verdicts = {
    {"Armadillo_Tetra_4406_for_test_broken.vtu", {": files with extension .vtu are not read"}},
    {"Th.msh", {": files with extension .msh are not read"}},
    {"bad-stl-tardis.stl", {""}},
    {"box_UTF16BE.obj", {": this is UTF-16 text"}},
    {"bunny.off", {": this is a web page"}},
    // 2 of its 14 faces have one or two distinct vertices; they are left out.
    {"cube-minimal-degenerated.obj", {""}},
    {"degenerate_edge.obj", {""}},
    // Every face once more, reversed; those are left out.
    {"degenerated.obj", {""}},
    {"elephav.obj", {": this is a Git LFS pointer"}},
    {"empty.msh", {": files with extension .msh are not read"}},
    {"empty.obj", {": the file is empty"}},
    {"empty.stl", {": the file has no facet"}},
    // A legal OBJ file: the last line may end without a newline.
    {"eof_test.obj", {""}},
    // The header declares 15 values per face, the lines have 21 (a list of nine colours, not four values).
    {"fuze_ascii.ply", {":523: the line has more values than the header declares"}},
    {"index0.obj", {":9: vertex index 0"}},
    {"inf_nan.obj", {":1: the vertex is not finite"}},
    {"invalid-relative-vertex-index.obj", {":1: vertex index -4 in the face is out of range"}},
    {"invalid.off", {":6: the face has 0 corners"}},
    {"issue-140-zero-face-idx.obj", {":16: vertex index 0"}},
    {"malformed.obj", {":28: vertex index 0"}},
    {"mni-surface-mesh.obj", {":1: this is not a Wavefront OBJ file"}},
    {"nancolor.obj", {""}},
    {"notenoughindices.obj", {":9: the face has 2 corners"}},
    {"square.obj", {":3: the vertex has 2 numbers"}},
    {"test-nan.obj", {":12: the vertex is not finite"}},
    {"unparseable.stl", {":4: '?' is not a number"}},
    {"whitespace.off", {""}},
    {"zero_area_face.obj", {":9: the face has no area"}}};

TEST(Malformed, EveryFileIsRefusedWithItsReasonOrIsLegal) {
  const fs::path root = shared("malformed");
  if (root.empty()) GTEST_SKIP() << "no shared data";
  for (const auto& entry : fs::directory_iterator(root)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".gz") continue;
    ASSERT_TRUE(verdicts.contains(name)) << name;
    const std::string error = error_of([&] { read_mesh(entry.path()); });
    const std::string& expected = verdicts.at(name).message;
    if (expected.empty())
      EXPECT_EQ(error, "") << name;
    else
      EXPECT_NE(error.find(name + expected), std::string::npos) << name << "\n" << error;
  }
}

TEST(Malformed, EveryTexturedFileIsRead) {
  const fs::path root = shared("textured");
  if (root.empty()) GTEST_SKIP() << "no shared data";
  std::vector<fs::path> files = files_under(root, ".obj");
  for (const fs::path& file : files_under(root, ".ply")) files.push_back(file);
  EXPECT_FALSE(files.empty());
  for (const fs::path& file : files) EXPECT_EQ(error_of([&] { read_mesh(file); }), "") << file;
}

TEST(Malformed, EveryPlyOfTheSharedDataIsReadOrRefusedWithItsName) {
  const fs::path root = shared("textured");
  if (root.empty()) GTEST_SKIP() << "no shared data";
  for (const fs::path& file : files_under(root.parent_path(), ".ply")) {
    const std::string error = error_of([&] { read_mesh(file); });
    EXPECT_TRUE(error.empty() || error.find(file.filename().string()) != std::string::npos) << error;
  }
}

class NoMesh : public IoTest {
 protected:
  std::string refusal(const fs::path& path) const {
    return error_of([&] { read_mesh(path); });
  }
};

TEST_F(NoMesh, MissingFilesDirectoriesAndDevices) {
  EXPECT_EQ(refusal(directory / "no.obj"),
            (directory / "no.obj").string() + ": the file does not exist; check the path");
  EXPECT_NE(refusal(directory).find("this is a directory"), std::string::npos);
  fs::create_directory(directory / "d.ply");
  EXPECT_NE(refusal(directory / "d.ply").find("this is a directory"), std::string::npos);
  EXPECT_NE(refusal("/dev/null").find("not a regular file"), std::string::npos);
  EXPECT_NE(refusal(directory / "no" / "a.ply").find("does not exist"), std::string::npos);
}

TEST_F(NoMesh, UnreadableFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "root reads everything";
  const fs::path path = file("a.obj", "v 0 0 0\n");
  fs::permissions(path, fs::perms::none);
  EXPECT_NE(refusal(path).find("permission denied"), std::string::npos);
}

TEST_F(NoMesh, ForeignContentIsNamed) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"\n <!DOCTYPE html><html>", "web page"},
      {"<?xml version='1.0'?>", "XML"},
      {std::string("\x1F\x8B\x08\0", 4), "gzip"},
      {"PK\x03\x04", "ZIP"},
      {std::string("\xFF\xFEv\0 \0", 6), "UTF-16"},
      {std::string("v 0\0 0", 6), "binary"},
      {"solid a\nfacet", "STL"},
      {"ply\nformat ascii 1.0\n", "PLY"},
      {"v 0 0 0\n", "no face"},
      {"v 0 0 0\nv 1 1 1\nl 1 2\n", "lines or curves but no face"},
      {"# only a comment\n", "no vertex and no face"},
      {"   \n\n", "no vertex and no face"}};
  for (const auto& [text, expected] : cases)
    EXPECT_NE(refusal(file("x.obj", text)).find(expected), std::string::npos) << expected;
  EXPECT_NE(refusal(file("x.ply", "v 0 0 0\n")).find("not a PLY file"), std::string::npos);
}

}  // namespace
}  // namespace multimesh::io::test
