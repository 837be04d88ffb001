// SPDX-License-Identifier: BSD-3-Clause
// Periodic tiles, end to end: files in, files out.
#include <fstream>
#include <sstream>

#include "test/tools/program.hpp"

namespace multimesh::tools::test {
namespace {

class PeriodicCommands : public ProgramTest {
 protected:
  /// An n x n grid of a square with side 2 as OBJ, all corners at integers, but the inner ones shaken, and so
  /// are those on the sides along their side.
  void write_square(const std::string& name, int n, double gap = 0) const {
    std::ostringstream text;
    const auto shake = [n](int i, int j) {
      return i == 0 || i == n ? 0.0 : 0.3 * ((7 * i + 5 * (j % n)) % 5 - 2) / 2;
    };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        text << "v " << 2 * (i + shake(i, j)) / n << ' '
             << 2 * (j + shake(j, i)) / n + (i == n && j == n / 2 ? gap : 0) << " 0\n";
    const auto v = [n](int i, int j) { return i * (n + 1) + j + 1; };
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        text << "f " << v(i, j) << ' ' << v(i + 1, j) << ' ' << v(i + 1, j + 1) << "\nf " << v(i, j) << ' '
             << v(i + 1, j + 1) << ' ' << v(i, j + 1) << '\n';
    std::ofstream(directory / name) << text.str();
  }

  /// A cube of n^3 cubes in two regions, in MSH 2.2.
  void write_cube(const std::string& name, int n) const {
    std::ofstream out(directory / name);
    out.precision(17);
    out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n3 1 \"matrix\"\n3 2 \"fibre\"\n"
        << "$EndPhysicalNames\n$Nodes\n"
        << (n + 1) * (n + 1) * (n + 1) << '\n';
    int number = 0;
    const auto shake = [n](int i, int j, int k) {
      return i == 0 || i == n ? 0.0 : 0.35 * ((3 * i + 5 * (j % n) + 7 * (k % n)) % 7 - 3) / 3;
    };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j)
        for (int k = 0; k <= n; ++k)
          out << ++number << ' ' << (i + shake(i, j, k)) / n << ' ' << (j + shake(j, k, i)) / n << ' '
              << (k + shake(k, i, j)) / n << '\n';
    out << "$EndNodes\n$Elements\n" << 6 * n * n * n << '\n';
    const int step[3] = {(n + 1) * (n + 1), n + 1, 1};
    const int orders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    number = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k)
          for (int o = 0; o < 6; ++o) {
            const int region = i < 2 && k > 0 ? 2 : 1;
            int v = i * step[0] + j * step[1] + k * step[2] + 1;
            out << ++number << " 4 2 " << region << ' ' << region << ' ' << v;
            int w[3];
            for (int s = 0; s < 3; ++s) w[s] = v += step[orders[o][s]];
            if (o > 2) std::swap(w[0], w[1]);
            for (const int x : w) out << ' ' << x;
            out << '\n';
          }
    out << "$EndElements\n";
  }

  /// What `info --periodic` says; the test fails if that fails.
  Json tile(const std::string& file, const Arguments& more) const {
    Arguments arguments{"info", file, "--report", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended e = run(arguments);
    EXPECT_EQ(e.status, 0) << e.err;
    return e.status == 0 ? Json::parse(e.out)["periodic"] : Json();
  }
};

TEST_F(PeriodicCommands, InfoDescribesTheGluedTile) {
  write_square("in.obj", 6);
  const Json t = tile("in.obj", {"--periodic", "xyz"});
  EXPECT_EQ(t["glued"]["vertices"], 36);
  EXPECT_EQ(t["glued"]["euler_characteristic"], 0);
  EXPECT_EQ(t["copies"], (Json{{"1", 25}, {"2", 10}, {"4", 1}}));
  EXPECT_EQ(t["periods"].size(), 2U);
  EXPECT_TRUE(t["flat_sides"]);
  EXPECT_TRUE(contains(run({"info", "in.obj", "--periodic", "xyz"}).err, "no extent along z"));
}

TEST_F(PeriodicCommands, RefuseSidesThatDoNotMatch) {
  write_square("in.obj", 6, 0.01);
  for (const Arguments& a : {Arguments{"info", "in.obj", "--periodic", "xy"},
                             {"remesh", "in.obj", "-o", "out.obj", "--length", "0.3", "--periodic", "xy"}}) {
    const Ended e = run(a);
    EXPECT_EQ(e.status, 1);
    for (const char* part : {"in.obj", "along x", "vertex", "distance 0.01"})
      EXPECT_TRUE(contains(e.err, part)) << e.err;
  }
  EXPECT_FALSE(exists("out.obj"));
}

TEST_F(PeriodicCommands, RefuseWrongUsage) {
  write_square("in.obj", 6);
  EXPECT_EQ(run({"info", "in.obj", "--periodic", "xw"}).status, 2);
  EXPECT_EQ(run({"info", "in.obj", "--periodic", "xy", "--periods", "1,0"}).status, 2);
  EXPECT_EQ(run({"info", "in.obj", "--periods", "1,0,0"}).status, 2);
  const Ended e = run({"info", "in.obj", "--periodic", "xy", "--periods", "2,0,0"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "give one per axis")) << e.err;
  EXPECT_EQ(run({"remesh", "in.obj", "-o", "o.obj", "--length", "1", "--pair-table", "p.csv"}).status, 2);
  EXPECT_EQ(
      run({"remesh", "in.obj", "-o", "o.obj", "--length", "1", "--periodic", "xy", "--pair-table", "o.obj"})
          .status,
      1);
}

TEST_F(PeriodicCommands, RemeshWritesATileThatIsGluedAgain) {
  write_square("in.obj", 8);
  for (const std::string sides : {"flat", "free", "frozen"}) {
    const Ended e = run({"remesh", "in.obj", "-o", "out.msh", "--length", "0.2", "--periodic", "xy",
                         "--sides", sides, "--pair-table", "pairs.csv", "--report", "report.json"});
    ASSERT_EQ(e.status, 0) << e.err;
    const Json r = json("report.json")["periodic"];
    EXPECT_EQ(r["sides"], sides);
    EXPECT_EQ(r["after"]["inverted"], 0);
    EXPECT_LE(r["after"]["mismatch"], 1e-15);
    const Json t = tile("out.msh", {"--periodic", "xy"});
    EXPECT_EQ(t["glued"]["euler_characteristic"], 0);
    EXPECT_EQ(t["glued"], r["after"]["glued"]);
    std::istringstream pairs(content("pairs.csv"));
    std::size_t lines = 0, copies = 0;
    for (std::string line; std::getline(pairs, line);) lines += std::isdigit(line[0]) != 0;
    for (const auto& [n, vertices] : t["copies"].items())
      copies += (std::stoul(n) - 1) * vertices.get<std::size_t>();
    EXPECT_EQ(lines, copies);
  }
}

TEST_F(PeriodicCommands, RemeshNotesALengthNearThePeriod) {
  write_square("in.obj", 8);
  const Ended e = run({"remesh", "in.obj", "-o", "out.obj", "--length", "1.2", "--periodic", "xy"});
  EXPECT_EQ(e.status, 0);
  EXPECT_TRUE(contains(e.err, "third of the period")) << e.err;
  EXPECT_EQ(tile("out.obj", {"--periodic", "xy"})["glued"]["euler_characteristic"], 0);
}

#ifdef MULTIMESH_WITH_IMPROVE

TEST_F(PeriodicCommands, RemeshTakesTheInterfacesOfTetrahedra) {
  write_cube("in.msh", 6);
  const Json before = tile("in.msh", {"--periodic", "xyz"});
  const Ended e = run({"remesh", "in.msh", "-o", "out.msh", "--length", "0.2", "--periodic", "xyz",
                       "--feature-angle", "40", "--report", "report.json"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json r = json("report.json"), t = tile("out.msh", {"--periodic", "xyz"});
  EXPECT_GT(r["tetrahedra"]["tetrahedra"], 0);
  EXPECT_EQ(t["glued"], r["periodic"]["after"]["glued"]);
  EXPECT_EQ(t["interfaces"], before["interfaces"]);
  EXPECT_EQ(t["inverted"], 0);
  EXPECT_TRUE(t["flat_sides"]);
  for (const char* region : {"1", "2"}) EXPECT_NEAR(t["regions"][region], before["regions"][region], 1e-3);
}

TEST_F(PeriodicCommands, DecimateWritesACoarserTile) {
  write_square("in.obj", 12);
  write_cube("in.msh", 6);
  for (const std::string in : {"in.obj", "in.msh"})
    for (const std::string sides : {"flat", "free", "frozen"}) {
      SCOPED_TRACE(in + " " + sides);
      const std::string axes = in == "in.obj" ? "xy" : "xyz";
      const Json before = tile(in, {"--periodic", axes});
      const Ended e = run({"decimate", in, "-o", "out.msh", "--ratio", "0.5", "--periodic", axes, "--sides",
                           sides, "--pair-table", "pairs.csv", "--report", "report.json"});
      ASSERT_EQ(e.status, 0) << e.err;
      const Json r = json("report.json");
      EXPECT_EQ(r["periodic"]["sides"], sides);
      EXPECT_LT(r["faces"]["after"], r["faces"]["before"]);
      EXPECT_LT(r["facets"]["after"], r["facets"]["before"]);
      const Json t = tile("out.msh", {"--periodic", axes});
      EXPECT_EQ(t["glued"], r["periodic"]["after"]["glued"]);
      EXPECT_EQ(t["glued"]["euler_characteristic"], before["glued"]["euler_characteristic"]);
      EXPECT_EQ(t["inverted"], 0);
      EXPECT_EQ(t["periods"], before["periods"]);
    }
}

TEST_F(PeriodicCommands, DecimateRefusesWhatATileHasNoUseFor) {
  write_square("in.obj", 6);
  const Arguments command{"decimate", "in.obj", "-o", "out.msh", "--ratio", "0.5", "--periodic", "xy"};
  for (const Arguments& more : {Arguments{"--levels", "0.8"}, {"--lock-seams"}, {"--uv-weight", "1"}}) {
    Arguments arguments = command;
    arguments.insert(arguments.end(), more.begin(), more.end());
    EXPECT_EQ(run(arguments).status, 2) << more.front();
  }
  Arguments arguments = command;
  arguments.emplace_back("--improve");
  EXPECT_EQ(run(arguments).status, 1);
}

TEST_F(PeriodicCommands, ImproveKeepsRegionsNamesAndTheBox) {
  write_cube("in.msh", 5);
  const Json before = tile("in.msh", {"--periodic", "xyz"});
  for (const Arguments& more : {Arguments{},
                                {"--msh2"},
                                {"--relative-envelope", "0.01"},
                                {"--lock-surface", "--feature-angle", "40"}}) {
    Arguments arguments{"improve",      "in.msh",     "-o",
                        "out.msh",      "--periodic", "xyz",
                        "--max-passes", "3",          "--abaqus-equations",
                        "out.inp",      "--report",   "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended e = run(arguments);
    ASSERT_EQ(e.status, 0) << e.err;
    const Json r = json("report.json");
    EXPECT_LT(r["after"]["max_amips"], r["before"]["max_amips"]);
    const Json after = tile("out.msh", {"--periodic", "xyz"});
    EXPECT_EQ(after["inverted"], 0);
    EXPECT_TRUE(after["flat_sides"]);
    EXPECT_EQ(after["periods"], before["periods"]);
    EXPECT_EQ(after["interfaces"], before["interfaces"]);
    for (const char* region : {"1", "2"})
      EXPECT_NEAR(after["regions"][region], before["regions"][region], more.size() > 1 ? 1e-3 : 1e-12);
    const Json groups = info("out.msh")["contents"]["groups"];
    for (const char* name : {"matrix", "fibre"})
      EXPECT_EQ(std::count_if(groups.begin(), groups.end(), [&](const Json& g) { return g["name"] == name; }),
                1);
    EXPECT_TRUE(contains(content("out.inp"), "*EQUATION"));
    EXPECT_TRUE(contains(content("out.inp"), "NSET=REF_Z"));
  }
}

/// In 2D and 3D, in both versions of MSH and in VTU, as other programs read them.
TEST_F(PeriodicCommands, SecondOrderIsReadByOthersWithAllItsPairs) {
  write_square("square.obj", 6);
  write_cube("cube.msh", 4);
  std::string jobs;
  for (const Arguments& form : {Arguments{"t41.msh", "--ascii"},
                                {"b41.msh"},
                                {"t22.msh", "--msh2", "--ascii"},
                                {"b22.msh", "--msh2"},
                                {"b.vtu"}}) {
    Arguments remesh{"remesh", "square.obj", "-o", "s" + form[0], "--length", "0.3"};
    Arguments improve{"improve", "cube.msh", "-o", "c" + form[0]};
    for (Arguments* a : {&remesh, &improve}) {
      const std::string out = (*a)[3];
      a->insert(a->end(), form.begin() + 1, form.end());
      for (const char* more : {"--periodic", "xyz", "--order", "2", "--pair-table"}) a->push_back(more);
      a->push_back(out + ".csv");
      const Ended e = run(*a);
      ASSERT_EQ(e.status, 0) << e.err;
      jobs += " " + (directory / out).string() + " " + (directory / out).string() + ".csv";
    }
  }
  if (std::system("/usr/bin/python3 -c 'import meshio' 2> /dev/null") != 0)
    GTEST_SKIP() << "meshio is not installed";
  const std::string script = "/usr/bin/python3 " MULTIMESH_TEST_DATA "/../second_order_by_peers.py";
  EXPECT_EQ(std::system((script + jobs).c_str()), 0);
}

TEST_F(PeriodicCommands, SecondOrderIsRefusedBeforeTheWorkForFormatsWithoutIt) {
  write_cube("cube.msh", 4);
  for (const char* out : {"o.mesh", "o.obj", "o.xyz"}) {
    const Ended e = run({"improve", "cube.msh", "-o", out, "--order", "2", "--periodic", "xyz"});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, ".msh")) << e.err;
    EXPECT_FALSE(exists(out));
  }
}

TEST_F(PeriodicCommands, WithoutPeriodicDeclaredSidesAreNotLostSilently) {
  write_cube("in.msh", 4);
  ASSERT_EQ(run({"improve", "in.msh", "-o", "tile.msh", "--periodic", "xyz"}).status, 0);
  const Ended as_tile = run({"improve", "tile.msh", "-o", "kept.msh"});
  EXPECT_EQ(as_tile.status, 0) << as_tile.err;
  EXPECT_TRUE(contains(as_tile.err, "as with --periodic xyz")) << as_tile.err;
  EXPECT_TRUE(contains(content("kept.msh"), "$Periodic"));
  EXPECT_EQ(run({"info", "kept.msh", "--periodic", "xyz"}).status, 0);
  const Ended refused = run({"improve", "tile.msh", "-o", "x.msh", "--lock-region", "1"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_TRUE(contains(refused.err, "--periodic")) << refused.err;
  EXPECT_FALSE(exists("x.msh"));
  EXPECT_TRUE(
      contains(run({"improve", "tile.msh", "-o", "x.msh", "--no-periodic"}).err, "links are dropped"));
}

#endif

}  // namespace
}  // namespace multimesh::tools::test
