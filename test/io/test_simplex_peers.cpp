// SPDX-License-Identifier: BSD-3-Clause
// Gmsh and meshio read what we write, and what they write of it is what we wrote.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "simplex_fixture.hpp"

namespace multimesh::io::test {
namespace {

/// The simplices of one dimension by tag and coordinates, in no order: peers renumber.
using Simplices = std::vector<std::pair<std::int32_t, std::vector<std::array<double, 3>>>>;

Simplices canonical(const SimplexSoup& soup, std::size_t dimension, bool tags = true) {
  Simplices all;
  const auto& block = soup.simplices[dimension];
  for (std::size_t i = 0; i < block.size(); ++i) {
    auto& [tag, corners] = all.emplace_back(tags ? block.tags[i] : 0, std::vector<std::array<double, 3>>{});
    for (std::size_t c = 0; c <= dimension; ++c)
      corners.push_back(soup.points[block.corners[(dimension + 1) * i + c]]);
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Nine decimals, for a peer that writes twelve digits.
SimplexSoup rounded(SimplexSoup soup) {
  for (auto& p : soup.points)
    for (double& x : p) x = std::round(1e9 * x);
  return soup;
}

class Peers : public IoTest {
 protected:
  int run(const std::string& command) const {
    return std::system(("cd '" + directory.string() + "' && " + command + " >log.txt 2>&1").c_str());
  }

  /// Two regions, tagged triangles, edges and points; without the extreme numbers, which Gmsh takes for one.
  static SimplexSoup soup() {
    SimplexSoup soup = small_soup();
    soup.points = {{0, 0, 0}, {1, 0, 0.1}, {0, 1, 1.0 / 3}, {0, 0, 1}, {1, 1, 1.0 / 7}, {2, 2, 2}};
    return soup;
  }
};

class GmshPeer : public Peers {
 protected:
  void SetUp() override {
    Peers::SetUp();
    if (run("gmsh --version") != 0) GTEST_SKIP() << "gmsh is not installed";
  }
};

TEST_F(GmshPeer, ReadsWhatWeWriteAndGivesItBack) {
  for (const Form& form : volume_forms) {
    if (form.name.ends_with(".vtu")) continue;  // Gmsh does not read it
    for (const char* version : {"msh22", "msh41"}) {
      SCOPED_TRACE(form.name + " " + version);
      write_simplices(directory / form.name, soup(), form.options);
      const int status =
          run("gmsh -0 -save_all -bin -format " + std::string(version) + " " + form.name + " -o out.msh");
      const std::string log = content(directory / "log.txt");
      ASSERT_EQ(status, 0) << log;
      EXPECT_EQ(log.find("Error"), std::string::npos) << log;
      EXPECT_EQ(log.find("Warning"), std::string::npos) << log;
      const SimplexSoup again = read_simplices(directory / "out.msh");
      const bool is_msh = form.name.ends_with(".msh");
      for (std::size_t k = is_msh ? 0 : 1; k < 4; ++k)
        EXPECT_EQ(canonical(soup(), k), canonical(again, k)) << k;
      if (is_msh) {
        EXPECT_EQ(again.groups.size(), 3U);
      }
    }
  }
}

/// Gmsh meshes a box and writes it in its formats; all have the same numbers of simplices.
TEST_F(GmshPeer, MeshesOfItsOwn) {
  file("box.geo",
       "SetFactory(\"OpenCASCADE\"); Box(1) = {0,0,0, 1,1,1}; Mesh.CharacteristicLengthMax = 0.4;\n"
       "Physical Volume(\"inside\", 5) = {1}; Physical Surface(\"walls\", 6) = {1:6};\n");
  if (run("gmsh -3 box.geo -format msh41 -o box.msh") != 0) GTEST_SKIP() << content(directory / "log.txt");
  const SimplexSoup first = read_simplices(directory / "box.msh");
  EXPECT_GT(first.simplices[3].size(), 50U);
  EXPECT_EQ(first.groups.size(), 2U);
  for (const auto& [options, name] :
       std::vector<std::pair<std::string, std::string>>{{"-bin -format msh41", "a.msh"},
                                                        {"-format msh22", "b.msh"},
                                                        {"-bin -format msh22", "c.msh"},
                                                        {"-order 2 -format msh41", "d.msh"},
                                                        {"-order 3 -bin -format msh22", "e.msh"},
                                                        {"-format mesh", "f.mesh"},
                                                        {"-format vtk", "g.vtk"},
                                                        {"-bin -format vtk", "h.vtk"},
                                                        {"-bin -format stl", "i.stl"},
                                                        {"-format stl", "j.stl"}}) {
    SCOPED_TRACE(name);
    ASSERT_EQ(run("gmsh -3 box.geo " + options + " -o " + name), 0) << content(directory / "log.txt");
    const SimplexSoup soup = read_simplices(directory / name);
    EXPECT_EQ(soup.simplices[2].size(), first.simplices[2].size());
    const bool is_stl = name.ends_with(".stl");
    EXPECT_EQ(soup.simplices[3].size(), is_stl ? 0 : first.simplices[3].size());
    if (!name.ends_with(".msh")) continue;
    EXPECT_EQ(soup.simplices[3].tags.front(), 5);
    EXPECT_EQ(soup.groups, first.groups);
  }
}

class MeshioPeer : public Peers {
 protected:
  void SetUp() override {
    Peers::SetUp();
    if (run("/usr/bin/python3 -c 'import meshio'") != 0) GTEST_SKIP() << "meshio is not installed";
  }

  /// All at once, for starting Python takes longer than the rest.
  void convert(const std::vector<std::array<std::string, 3>>& jobs) const {
    std::string command = "/usr/bin/python3 " MULTIMESH_TEST_SOURCE_DIR "/through_meshio.py";
    for (const auto& [in, out, form] : jobs) command += " " + in + " " + out + " " + form;
    const int status = run(command);
    ASSERT_EQ(status, 0) << content(directory / "log.txt");
  }
};

TEST_F(MeshioPeer, ReadsAndWritesEveryVolumeFormat) {
  const std::vector<std::pair<std::string, std::string>> targets = {
      {"gmsh22", ".msh"}, {"gmsh22-binary", ".msh"}, {"gmsh", ".msh"},      {"gmsh-binary", ".msh"},
      {"medit", ".mesh"}, {"vtu", ".vtu"},           {"vtu-plain", ".vtu"}, {"vtu-ascii", ".vtu"},
      {"vtk42", ".vtk"},  {"vtk42-binary", ".vtk"},  {"vtk51", ".vtk"},     {"vtk51-binary", ".vtk"}};
  std::vector<std::array<std::string, 3>> jobs;
  SimplexSoup tagged = soup();
  tagged.simplices[2].tags[1] = 0;  // meshio reads Gmsh's files only if all have a physical tag, or none
  for (const Form& form : volume_forms) {
    write_simplices(directory / form.name, tagged, form.options);
    for (const auto& [target, extension] : targets)
      jobs.push_back({form.name, form.name + target + extension, target});
  }
  convert(jobs);
  for (const auto& [in, out, target] : jobs) {
    SCOPED_TRACE(out);
    const SimplexSoup again = read_simplices(directory / out), written = read_simplices(directory / in);
    // Vertices: meshio neither writes them into MEDIT files nor reads them from there.
    const bool is_msh4 = target == "gmsh" || target == "gmsh-binary", is_short = target == "vtu-ascii";
    for (std::size_t k = is_msh4 ? 3 : 1; k < 4; ++k)
      EXPECT_EQ(canonical(is_short ? rounded(written) : written, k),
                canonical(is_short ? rounded(again) : again, k))
          << k;
  }
}

TEST_F(MeshioPeer, ReadsAndWritesEverySurfaceFormat) {
  const std::vector<std::pair<std::string, std::string>> targets = {
      {"stl", ".stl"}, {"stl-binary", ".stl"}, {"off", ".off"},
      {"ply", ".ply"}, {"ply-binary", ".ply"}, {"obj", ".obj"}};
  std::vector<std::array<std::string, 3>> jobs;
  SimplexSoup exact = soup();
  for (auto& p : exact.points) p[2] = p[0] + 0.25 * p[2] * (p[2] == 1);  // exact in floats
  for (const Form& form : surface_forms) {
    write_simplices(directory / form.name, exact, form.options);
    for (const auto& [target, extension] : targets)
      jobs.push_back({form.name, form.name + target + extension, target});
  }
  convert(jobs);
  for (const auto& [in, out, target] : jobs) {
    SCOPED_TRACE(out);
    EXPECT_EQ(canonical(exact, 2, false), canonical(read_simplices(directory / out, {1, 1}), 2));
  }
}

}  // namespace
}  // namespace multimesh::io::test
