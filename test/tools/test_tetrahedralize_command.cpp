// SPDX-License-Identifier: BSD-3-Clause
// tetrahedralize end to end: several materials, names, seeds, missed sizes, and runs that do not end.
#include <signal.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <numeric>
#include <set>
#include <sstream>
#include <thread>

#include "multimesh/io/simplex_reader.hpp"
#include "program.hpp"
#include "test/tetgen/voxels.hpp"

namespace multimesh::tools::test {
namespace {

using multimesh::test::Listing;
using multimesh::test::Voxels;

#ifdef MULTIMESH_WITH_TETGEN

using Corner = std::array<int, 3>;
using Triangles = std::vector<std::array<Corner, 3>>;

/// The cube [x, x + 1] x [0, 1]^2, oriented outwards.
Triangles cube_at(int x, bool with_low_side = true) {
  constexpr int quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1},
                               {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}};
  const auto corner = [&](int i) { return Corner{x + (i >> 2), i >> 1 & 1, i & 1}; };
  Triangles all;
  for (const auto& q : quads) {
    if (!with_low_side && &q == &quads[0]) continue;
    all.push_back({corner(q[0]), corner(q[1]), corner(q[2])});
    all.push_back({corner(q[0]), corner(q[2]), corner(q[3])});
  }
  return all;
}

std::string stl(const std::vector<std::pair<std::string, Triangles>>& solids) {
  std::ostringstream out;
  for (const auto& [name, triangles] : solids) {
    out << "solid " << name << '\n';
    for (const auto& t : triangles) {
      out << "facet normal 0 0 0\nouter loop\n";
      for (const Corner& c : t) out << "vertex " << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
      out << "endloop\nendfacet\n";
    }
    out << "endsolid " << name << '\n';
  }
  return out.str();
}

/// Triangles after lines such as "g left".
std::string obj(const std::vector<std::pair<std::string, Triangles>>& parts) {
  std::map<Corner, std::size_t> number;
  std::ostringstream points, faces;
  for (const auto& [head, triangles] : parts) {
    faces << head << '\n';
    for (const auto& t : triangles) {
      faces << 'f';
      for (const Corner& c : t) {
        const auto [at, is_new] = number.try_emplace(c, number.size() + 1);
        if (is_new) points << "v " << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
        faces << ' ' << at->second;
      }
      faces << '\n';
    }
  }
  return points.str() + faces.str();
}

class TetrahedralizeCommand : public ProgramTest {
 protected:
  Json filled(const std::string& in, const Arguments& more = {}, const std::string& out = "out.msh") const {
    Arguments arguments{"tetrahedralize", in, "-o", out, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended e = run(arguments);
    EXPECT_EQ(e.status, 0) << in << ": " << e.err;
    EXPECT_EQ(run({"validate", out}).status, 0);
    return e.out.empty() ? Json() : Json::parse(e.out);
  }
  std::set<std::string> names_in_file(int dimension) const {
    std::set<std::string> names;
    for (const auto& g : io::read_simplices(directory / "out.msh").groups)
      if (g.dimension == dimension) names.insert(g.name);
    return names;
  }
};

std::set<std::string> names_of(const Json& parts) {
  std::set<std::string> names;
  for (const Json& part : parts) names.insert(part.value("name", ""));
  return names;
}

TEST_F(TetrahedralizeCommand, SolidsOfAnStlFileAreRegions) {
  file("two.stl", stl({{"left part", cube_at(0)}, {"right", cube_at(1)}}));
  const Json j = filled("two.stl");
  EXPECT_EQ(names_of(j["regions"]), (std::set<std::string>{"left part", "right"}));
  EXPECT_EQ(names_of(j["patches"]), (std::set<std::string>{"left part", "right", "left part+right"}));
  for (const Json& region : j["regions"]) EXPECT_NEAR(region["volume"].get<double>(), 1, 1e-12);
  for (const Json& patch : j["patches"])
    EXPECT_EQ(patch["triangles"], patch["name"] == "left part+right" ? 2 : 10);
  EXPECT_EQ(names_in_file(3), (std::set<std::string>{"left part", "right"}));
  EXPECT_EQ(names_in_file(2), (std::set<std::string>{"left part", "right", "left part+right"}));
}

TEST_F(TetrahedralizeCommand, GroupsAndObjectsOfAnObjFileAreRegions) {
  file("once.obj", obj({{"g left", cube_at(0)}, {"g right", cube_at(1, false)}}));
  file("objects.obj", obj({{"o all\ng left", cube_at(0)}, {"g right", cube_at(1)}}));
  file("same_group.obj", obj({{"o left\ng default", cube_at(0)}, {"o right\ng default", cube_at(1)}}));
  for (const char* in : {"once.obj", "objects.obj", "same_group.obj"}) {
    const Json j = filled(in);
    EXPECT_EQ(names_of(j["regions"]), (std::set<std::string>{"left", "right"})) << in;
    EXPECT_EQ(j["patches"].size(), 3U) << in;
    EXPECT_EQ(j["surface"]["faces"], 22) << in;
  }
  EXPECT_EQ(names_in_file(2),
            (std::set<std::string>{"left/default", "right/default", "left/default+right/default"}));
}

TEST_F(TetrahedralizeCommand, RegionsHaveTagsInEveryFormat) {
  file("two.stl", stl({{"left", cube_at(0)}, {"right", cube_at(1)}}));
  for (const char* out : {"out.msh", "out.mesh", "out.vtu"}) {
    filled("two.stl", {}, out);
    const Json m = info(out)["meshes"];
    EXPECT_EQ(m["regions"].size(), 2U) << out;
    EXPECT_EQ(m["patches"].size(), 3U) << out;
  }
}

TEST_F(TetrahedralizeCommand, SeedsNameRegionsAndMakeHoles) {
  file("once.obj", obj({{"", cube_at(0)}, {"", cube_at(1, false)}}));
  const Json named = filled("once.obj", {"--region", "oil:1.5,.5,.5", "--region", "7:0.5,0.5,0.5"});
  ASSERT_EQ(named["regions"].size(), 2U);
  EXPECT_EQ(named["regions"][0]["name"], "oil");
  EXPECT_EQ(named["regions"][1]["tag"], 7);
  EXPECT_EQ(named["warnings"], Json::array()) << "seeds are no assumption";
  const Json hole = filled("once.obj", {"--hole", "1.5,.5,.5"});
  ASSERT_EQ(hole["regions"].size(), 1U);
  EXPECT_NEAR(hole["regions"][0]["volume"].get<double>(), 1, 1e-12);
  EXPECT_TRUE(contains(hole["warnings"].dump(), "10 triangles bound nothing that is filled"));
  const Ended outside = run({"tetrahedralize", "once.obj", "-o", "no.msh", "--hole", "-1,0,0"});
  EXPECT_EQ(outside.status, 1);
  EXPECT_TRUE(contains(outside.err, "at (-1, 0, 0) is in no region")) << outside.err;
  EXPECT_FALSE(exists("no.msh"));
  for (const Arguments& wrong :
       {Arguments{"--hole", "1,2"}, {"--region", "1,2,3"}, {"--region", "a:1,2,x"}}) {
    const Ended e = run({"tetrahedralize", "once.obj", "-o", "no.msh", wrong[0], wrong[1]});
    EXPECT_EQ(e.status, 2) << wrong[1];
    EXPECT_TRUE(contains(e.err, wrong[0])) << e.err;
  }
}

TEST_F(TetrahedralizeCommand, FaultsOfTrianglesAreRepairedWithAWarning) {
  Triangles t = cube_at(0);
  std::swap(t[1][0], t[1][1]);
  t.push_back(t[4]);
  t.push_back({t[0][0], t[0][0], t[0][1]});
  file("faults.obj", obj({{"", t}}));
  const Ended e = run({"tetrahedralize", "faults.obj", "-o", "out.msh"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(contains(e.err, "warning: ")) << e.err;
  EXPECT_TRUE(contains(e.err, "1 triangle run against the others")) << e.err;
  EXPECT_EQ(info("out.msh")["meshes"]["surface"]["faces"], 12);
}

/// The same triangles as an STL file with a solid per material.
std::string stl(const Voxels& voxels) {
  std::mt19937 random(1);
  const Voxels::Surface surface = voxels.surface(Listing::by_solid, random);
  std::ostringstream out;
  for (std::size_t t = 0; t < surface.material.size(); ++t) {
    const bool is_first = t == 0 || surface.material[t] != surface.material[t - 1];
    if (is_first) out << (t > 0 ? "endsolid\n" : "") << "solid m" << surface.material[t] << '\n';
    out << "facet normal 0 0 0\nouter loop\n";
    for (const Index v : surface.triangles.facet(t)) {
      const auto& p = surface.points[v];
      out << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    out << "endloop\nendfacet\n";
  }
  return out.str() + "endsolid\n";
}

TEST_F(TetrahedralizeCommand, MeshioAndGmshReadEveryRegionAndPatch) {
  const auto command = [&](const std::string& line) {
    return std::system(("cd '" + directory.string() + "' && " + line + " >log.txt 2>&1").c_str());
  };
  const bool has_meshio = command("/usr/bin/python3 -c 'import meshio'") == 0,
             has_gmsh = command("gmsh --version") == 0;
  if (!has_meshio && !has_gmsh) GTEST_SKIP() << "neither is installed";
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const Voxels voxels = Voxels::random(3, 3, 0.8, random);
    file("in.stl", stl(voxels));
    const bool is_2 = seed % 2 == 1;
    const Ended e = run({"tetrahedralize", "in.stl", "-o", "out.msh", "--json", is_2 ? "--msh2" : "--ascii"});
    ASSERT_EQ(e.status, 0) << e.err;
    const Json j = Json::parse(e.out);
    if (has_gmsh) {
      command("gmsh -check out.msh");
      const std::string log = content("log.txt");
      EXPECT_EQ(log.find("Error"), std::string::npos) << log;
      EXPECT_EQ(log.find("Warning"), std::string::npos) << log;
    }
    if (!has_meshio) continue;
    ASSERT_EQ(command("/usr/bin/python3 " MULTIMESH_TEST_DATA "/volumes_by_meshio.py out.msh"), 0)
        << content("log.txt");
    std::istringstream lines(content("log.txt"));
    std::size_t regions = 0, patches = 0;
    std::map<std::string, double> volume;  // per material
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string kind, tag, size, amount, name;
      for (std::string* word : {&kind, &tag, &size, &amount, &name}) std::getline(words, *word, ';');
      regions += kind == "tetra", patches += kind == "triangle";
      if (kind == "tetra") volume[name.substr(0, name.find('.'))] += std::stod(amount);
    }
    EXPECT_EQ(regions, j["regions"].size());
    EXPECT_EQ(patches, j["patches"].size());
    std::map<std::string, double> expected;
    for (int i = 0; i < 27; ++i)
      if (const int m = voxels.material({i % 3, i / 3 % 3, i / 9}); m != 0)
        expected["m" + std::to_string(m)] += 0.125;
    ASSERT_EQ(volume.size(), expected.size());
    for (const auto& [name, v] : expected) EXPECT_NEAR(volume[name], v, 1e-6) << name;
  }
}

TEST_F(TetrahedralizeCommand, ManySolidsMayListWhatIsBetweenThem) {
  std::vector<int> materials(64);
  std::iota(materials.begin(), materials.end(), 1);
  file("in.stl", stl(Voxels(4, materials)));
  const Json j = filled("in.stl");
  ASSERT_EQ(j["regions"].size(), 64U);
  EXPECT_EQ(j["patches"].size(), 56U + 144U) << "of solids at the border, and between two";
  EXPECT_EQ(names_of(j["regions"]).size(), 64U);
  for (const Json& region : j["regions"]) EXPECT_NEAR(region["volume"].get<double>(), 0.125, 1e-9);
}

TEST_F(TetrahedralizeCommand, SolidsThatNearlyTouchAreWelded) {
  std::string text = stl({{"left", cube_at(0)}, {"right", cube_at(1)}});
  // The solids have the corner (1, 0, 0) at two places.
  const std::size_t second = text.find("solid right"), at = text.find("vertex 1 0 0", second);
  for (std::size_t i = at; i != std::string::npos; i = text.find("vertex 1 0 0", i + 1))
    text.replace(i, 12, "vertex 1.00001 0 0");
  file("near.stl", text);
  ASSERT_EQ(run({"tetrahedralize", "near.stl", "-o", "gap.msh"}).status, 0);
  EXPECT_EQ(info("gap.msh")["meshes"]["surface"]["faces"], 24);
  const Json j = filled("near.stl", {"--weld", "1e-4"});
  EXPECT_EQ(j["regions"].size(), 2U);
  EXPECT_EQ(j["surface"]["faces"], 22);
  EXPECT_TRUE(contains(j["warnings"].dump(), "1 points are at the place of another one")) << j["warnings"];
}

TEST_F(TetrahedralizeCommand, MeetsTheEdgeLengthOnTheSurfaceToo) {
  file("cube.obj", obj({{"", cube_at(0)}}));
  file("two.stl", stl({{"left", cube_at(0)}, {"right", cube_at(1)}}));
  std::vector<int> hollow(27, 1);
  hollow[13] = 0;
  file("hollow.stl", stl(Voxels(3, hollow)));
  for (const char* in : {"cube.obj", "two.stl", "hollow.stl"}) {
    const Json coarse = filled(in), fine = filled(in, {"--edge-length", "0.3"});
    EXPECT_FALSE(contains(fine["warnings"].dump(), "missed")) << fine["warnings"];
    EXPECT_GT(fine["surface"]["faces"], coarse["surface"]["faces"]) << in;
    ASSERT_EQ(fine["regions"].size(), coarse["regions"].size()) << in;
    for (std::size_t i = 0; i < fine["regions"].size(); ++i) {
      const Json &now = fine["regions"][i], &before = coarse["regions"][i];
      EXPECT_EQ(now["tag"], before["tag"]) << in;
      EXPECT_NEAR(now["volume"].get<double>(), before["volume"].get<double>(), 1e-12) << in;
    }
    ASSERT_EQ(fine["patches"].size(), coarse["patches"].size()) << in;
    for (std::size_t i = 0; i < fine["patches"].size(); ++i)
      EXPECT_EQ(fine["patches"][i]["tag"], coarse["patches"][i]["tag"]) << in;
  }
}

TEST_F(TetrahedralizeCommand, TellsSizesThatAreMissed) {
  file("cube.obj", obj({{"", cube_at(0)}}));
  const Json kept = filled("cube.obj", {"--edge-length", "0.2", "--lock-surface"});
  EXPECT_TRUE(contains(kept["warnings"].dump(), "edge length 0.2 missed: ")) << kept["warnings"];
  EXPECT_TRUE(contains(kept["warnings"].dump(), "18 of them on the surface")) << kept["warnings"];
  EXPECT_EQ(filled("cube.obj", {"--edge-length", "3"})["warnings"], Json::array());
}

/// Whether a process is there.
bool is_alive(pid_t process) {
  return ::kill(process, 0) == 0;
}

TEST_F(TetrahedralizeCommand, EndsAtTheMemoryLimit) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "AddressSanitizer needs a large address space";
#endif
  file("cube.obj", obj({{"", cube_at(0)}}));
  const Ended e = run({"tetrahedralize", "cube.obj", "-o", "out.msh", "--split-surface", "--max-volume",
                       "1e-6", "--memory-limit", "40"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "cube.obj")) << e.err;
  EXPECT_TRUE(contains(e.err, "--memory-limit")) << e.err;
  EXPECT_FALSE(exists("out.msh"));
  EXPECT_EQ(run({"tetrahedralize", "cube.obj", "-o", "out.msh", "--memory-limit", "2000"}).status, 0);
  EXPECT_EQ(run({"tetrahedralize", "cube.obj", "-o", "out.msh", "--memory-limit", "0"}).status, 2);
}

TEST_F(TetrahedralizeCommand, EndsAtTheTimeLimitAndLeavesNoProcess) {
  file("cube.obj", obj({{"", cube_at(0)}}));
  const fs::path worker = file("worker.sh", "#!/bin/sh\necho $$ > pid\nexec sleep 100\n");
  fs::permissions(worker, fs::perms::owner_all);
  const auto use_worker = [&] { ::setenv("MULTIMESH_TETGEN_WORKER", worker.c_str(), 1); };
  const Ended e = run({"tetrahedralize", "cube.obj", "-o", "out.msh", "--time-limit", "0.01"}, use_worker);
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "cube.obj")) << e.err;
  EXPECT_TRUE(contains(e.err, "--time-limit")) << e.err;
  EXPECT_TRUE(contains(e.err, "multimesh remesh")) << e.err;
  EXPECT_FALSE(exists("out.msh"));
  EXPECT_FALSE(is_alive(std::stoi(content("pid"))));
}

TEST_F(TetrahedralizeCommand, AWorkerThatCrashesIsAnErrorThatNamesTheWayOut) {
  file("cube.obj", obj({{"", cube_at(0)}}));
  const fs::path worker = file("worker.sh", "#!/bin/sh\nkill -ABRT $$\n");
  fs::permissions(worker, fs::perms::owner_all);
  const Ended e = run({"tetrahedralize", "cube.obj", "-o", "out.msh"},
                      [&] { ::setenv("MULTIMESH_TETGEN_WORKER", worker.c_str(), 1); });
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "SIGABRT")) << e.err;
  EXPECT_TRUE(contains(e.err, "multimesh remesh")) << e.err;
  EXPECT_FALSE(exists("out.msh"));
}

TEST_F(TetrahedralizeCommand, TheWorkerEndsWithTheProgram) {
  file("cube.obj", obj({{"", cube_at(0)}}));
  // TetGen itself, at work that takes it minutes: with the surface as it is, it would give up at once.
  const pid_t p =
      start({"tetrahedralize", "cube.obj", "-o", "out.msh", "--max-volume", "1e-8", "--split-surface"});
  const fs::path children = fs::path("/proc") / std::to_string(p) / "task" / std::to_string(p) / "children";
  std::string worker;
  for (int i = 0; i < 50'000 && worker.empty(); ++i) {  // killed as soon as it is there, before it has begun
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    if (!fs::exists(children)) break;
    std::ifstream(children) >> worker;
  }
  ::kill(p, SIGKILL);
  wait(p);
  if (worker.empty()) GTEST_SKIP() << "this system does not list children";
  for (int i = 0; i < 500 && is_alive(std::stoi(worker)); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(is_alive(std::stoi(worker)));
}

#endif

}  // namespace
}  // namespace multimesh::tools::test
