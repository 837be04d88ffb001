// SPDX-License-Identifier: BSD-3-Clause
// Truncated or corrupted files of every format: an InputError or a consistent soup.
#include "adapters/io/msh_reader.hpp"
#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

class SimplexMalformed : public IoTest {
 protected:
  std::string bytes_of(const Form& form) {
    write_simplices(directory / form.name, small_soup(), form.options);
    return content(directory / form.name);
  }

  /// \return whether it was read
  static bool read(const std::string& name, const std::string& bytes, const ReadOptions& options = {}) {
    SimplexSoup soup;
    const std::string error = error_of([&] { soup = parse_simplices(bytes, name, options); });
    if (!error.empty()) {
      EXPECT_NE(error.find(name), std::string::npos) << error;
    }
    if (error.empty()) expect_valid(soup);
    return error.empty();
  }

  static std::vector<Form> forms() {
    std::vector<Form> all = volume_forms;
    all.insert(all.end(), surface_forms.begin(), surface_forms.end());
    return all;
  }
};

TEST_F(SimplexMalformed, FilesCutShortAnywhere) {
  for (const Form& form : forms()) {
    const std::string bytes = bytes_of(form);
    const bool has_end = form.name.ends_with(".msh") || form.name.ends_with(".vtu") || form.name == "b.stl" ||
                         form.name == "b.ply";
    for (std::size_t size = 0; size < bytes.size(); size += 3) {
      SCOPED_TRACE(form.name + " " + std::to_string(size));
      const bool was_read = read(form.name, bytes.substr(0, size));
      // Blanks and names behind the last keyword are nothing that is missed.
      if (has_end && size + 20 < bytes.size()) {
        EXPECT_FALSE(was_read);
      }
    }
  }
}

TEST_F(SimplexMalformed, DamagedBytes) {
  for (const Form& form : forms()) {
    const std::string bytes = bytes_of(form);
    for (std::size_t i = 0; i < bytes.size(); ++i)
      for (const char c : {'\0', '\xFF', '9', ' ', '\n', '-'}) {
        std::string damaged = bytes;
        damaged[i] = c;
        SCOPED_TRACE(form.name + " " + std::to_string(i));
        read(form.name, damaged, {1, 1});
      }
  }
}

TEST_F(SimplexMalformed, DamagedBytesOfPeriodicAndHighOrderFiles) {
  const std::string text =
      "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Entities\n0 0 0 1\n5 0 0 0 1 1 1 2 -30 31 0\n$EndEntities\n"
      "$Nodes\n2 5 1 9\n0 1 0 1\n9\n0 0 0\n3 5 1 4\n1\n2\n3\n4\n1 0 0 .1 .1 .1\n0 1 0 .2 .2 .2\n"
      "0 0 1 .3 .3 .3\n1 1 1 .4 .4 .4\n$EndNodes\n$Elements\n2 2 1 2\n3 5 4 1\n1 9 1 2 3\n2 6 9 1\n2 1 2 3 4 "
      "9 1\n"
      "$EndElements\n$Periodic\n1\n0 17 11\n1 2.5\n1\n9 4\n$EndPeriodic\n";
  ASSERT_TRUE(read("a.msh", text));
  for (std::size_t i = 0; i < text.size(); ++i)
    for (const char c : {'\0', '\xFF', '9', ' ', '\n', '-', '$'}) {
      std::string damaged = text;
      damaged[i] = c;
      SimplexSoup soup;
      if (error_of([&] { soup = parse_msh(damaged, "a.msh", {1, 1}); }).empty()) expect_valid(soup);
    }
}

/// A claimed number of 2^60 and more, in every number of a binary file that may be one.
TEST_F(SimplexMalformed, ForgedNumbersAllocateNothing) {
  for (const Form& form : forms()) {
    if (!form.options.binary) continue;
    const std::string bytes = bytes_of(form);
    for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
      std::string forged = bytes;
      for (std::size_t b = 4; b < 8; ++b) forged[i + b] = '\x0F';
      SCOPED_TRACE(form.name + " " + std::to_string(i));
      read(form.name, forged, {1, 1});
    }
  }
}

TEST_F(SimplexMalformed, WhatIsNoMeshIsNamed) {
  const std::vector<std::array<std::string, 3>> cases = {
      {"a.msh", "9 8 8\n0 0 4\n", "not a file of Gmsh"},
      {"a.msh", "", "the file is empty"},
      {"a.mesh", "something\n", "neither a MEDIT file nor one of MFEM"},
      {"a.mesh", "<!DOCTYPE html><html>", "web page"},
      {"a.vtu", "version https://git-lfs.github.com/spec/v1\n", "Git LFS pointer"},
      {"a.vtu", "<html><body>", "web page"},
      {"a.vtk", "x", "not a file of VTK"},
      {"a.meshb", std::string("\1\0\0\0\2\0\0\0", 8), "binary MEDIT files are not read"},
      {"a.xyz", "1 2 3", "files with extension .xyz are not read"},
      {"a", "1 2 3", "no extension"},
      {"a.obj", "v 0 0 0\n", "no face"},
      {"a.obj", "v 0 0 0\nl 1 2\n", ":2: the line names vertex 2 but the file has 1"},
      {"a.obj", "v 0 0 0\nl 1\n", ":2: the line has 1 vertices"}};
  for (const auto& [name, text, expected] : cases) {
    const std::string error = error_of([&, &n = name, &t = text] { read_simplices(file(n, t)); });
    EXPECT_NE(error.find(expected), std::string::npos) << error;
  }
  EXPECT_NE(error_of([&] { read_simplices(directory / "no.msh"); }).find("does not exist"),
            std::string::npos);
  EXPECT_NE(error_of([&] { read_simplices(directory); }).find("directory"), std::string::npos);
}

TEST_F(SimplexMalformed, TheContentCountsWhereItSaysWhatItIs) {
  for (const Form& form : volume_forms) {
    const std::string bytes = bytes_of(form);
    for (const char* name : {"x.msh", "x.mesh", "x.vtu", "x.dat", "x"})
      EXPECT_TRUE(read(name, bytes)) << form.name;
  }
}

TEST_F(SimplexMalformed, LinesOfObjAreEdges) {
  const SimplexSoup soup =
      read_simplices(file("a.obj", "v 0 0 0\nl 1 2/1 -1 4\nv 1 0 0\nv 1 1 0\nv 2 2 2\nf 1 2 3\n"));
  EXPECT_EQ(soup.simplices[1].size(), 3U);
  EXPECT_EQ(soup.simplices[2].size(), 1U);
}

}  // namespace
}  // namespace multimesh::io::test
