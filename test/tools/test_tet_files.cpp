// SPDX-License-Identifier: BSD-3-Clause
// What the commands keep of a tetrahedral file, and how they treat unusual ones, end to end. Peers (meshio,
// gmsh) are run if they are installed.
#include <cstdlib>
#include <set>

#include "adapters/io/group_tags.hpp"
#include "multimesh/io/simplex_reader.hpp"
#include "multimesh/io/simplex_writer.hpp"
#include "test/tools/listed_domain.hpp"
#include "test/tools/program.hpp"

namespace multimesh::tools::test {
namespace {

using io::SimplexSoup;

using Place = std::array<double, 3>;

/// Simplices by the places of their corners, with the groups that they are in.
std::map<std::vector<Place>, std::vector<std::int32_t>> by_place(const SimplexSoup& soup, std::size_t k) {
  std::map<std::vector<Place>, std::vector<std::int32_t>> all;
  const auto& block = soup.simplices[k];
  for (std::size_t i = 0; i < block.size(); ++i) {
    std::vector<Place> corners;
    for (std::size_t c = 0; c <= k; ++c) corners.push_back(soup.points[block.corners[(k + 1) * i + c]]);
    std::ranges::sort(corners);
    all[corners] = io::groups_of(soup, static_cast<int>(k), block.tags[i]);
  }
  return all;
}

class TetFiles : public ProgramTest {
 protected:
  static std::string data(const std::string& name) { return MULTIMESH_TEST_DATA "/" + name; }
  int shell(const std::string& command) const {
    return std::system(("cd '" + directory.string() + "' && " + command + " >log.txt 2>&1").c_str());
  }
  bool has(const std::string& command) const { return shell(command) == 0; }

  Json validated(const std::string& in, int status) const {
    const Ended e = run({"validate", in, "--json"});
    EXPECT_EQ(e.status, status) << in << e.out << e.err;
    return e.out.empty() ? Json() : Json::parse(e.out);
  }

  /// Every element has a positive tag.
  void expect_positive(const SimplexSoup& soup) const {
    for (const auto& block : soup.simplices)
      for (const std::int32_t tag : block.tags) ASSERT_GT(tag, 0);
  }
  /// By peers that are installed: Gmsh's check finds nothing, meshio reads it, all physical tags are
  /// positive.
  void expect_read_by_peers(const std::vector<std::string>& files) const {
    std::string list;
    for (const std::string& f : files) list += " " + f;
    const bool has_gmsh = has("gmsh --version"), has_meshio = has("/usr/bin/python3 -c 'import meshio'");
    for (std::size_t i = 0; has_gmsh && i < files.size(); ++i) {
      EXPECT_EQ(shell("gmsh -0 -check " + files[i] + " -o out_of_gmsh.msh"), 0) << files[i];
      const std::string log = content("log.txt");
      for (const char* bad : {"Error", "Warning"})
        EXPECT_EQ(log.find(bad), std::string::npos) << files[i] << log;
    }
    if (!has_meshio) return;
    EXPECT_EQ(shell("/usr/bin/python3 " MULTIMESH_TEST_DATA "/../read_by_meshio.py" + list), 0)
        << content("log.txt");
  }
};

struct OutputForm {
  const char* name;
  const char* option;
};
constexpr OutputForm output_forms[] = {{"b41.msh", nullptr},
                                       {"t41.msh", "--ascii"},
                                       {"b22.msh", "--msh2"},
                                       {"a.mesh", nullptr},
                                       {"b.vtu", nullptr}};

#ifdef MULTIMESH_WITH_IMPROVE

/// A mesh that needs no improvement comes out as it went in: every listed element with all its groups, none
/// besides, and names; in Gmsh's formats with positive tags.
TEST_F(TetFiles, ImproveWritesWhatIsListedWithItsGroupsAndNoMore) {
  std::vector<std::string> written;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const std::string in = "in" + std::to_string(seed) + (seed % 3 == 1 ? ".vtu" : ".msh");
    io::write_simplices(directory / in, random_domain(seed), {.binary = seed % 2 == 0});
    const SimplexSoup before = io::read_simplices(directory / in);
    for (const OutputForm& form : output_forms) {
      const std::string out = "out" + std::to_string(seed) + form.name;
      Arguments arguments{"improve", in, "-o", out};
      if (form.option != nullptr) arguments.emplace_back(form.option);
      const Ended e = run(arguments);
      ASSERT_EQ(e.status, 0) << e.err;
      const SimplexSoup after = io::read_simplices(directory / out);
      const bool is_msh = out.ends_with(".msh"), is_medit = out.ends_with(".mesh");
      // Gmsh takes an element that its version 2.2 lists for several groups for duplicates, also of its own.
      if (is_msh && (before.tag_sets.empty() || form.name != std::string("b22.msh"))) written.push_back(out);
      if (is_msh) {
        expect_positive(after);
        for (const auto& group : before.groups)
          EXPECT_NE(std::ranges::find(after.groups, group), after.groups.end()) << out << group.name;
      }
      for (std::size_t k = 0; k < 4; ++k) {
        const auto a = by_place(before, k), b = by_place(after, k);
        ASSERT_EQ(a.size(), b.size()) << out << " " << k;
        for (const auto& [corners, groups] : a) {
          ASSERT_TRUE(b.contains(corners)) << out << " " << k;
          const bool is_kept =
              is_msh ? groups != std::vector<std::int32_t>{0} : groups.size() == 1 && !(is_medit && k == 0);
          EXPECT_TRUE(!is_kept || b.at(corners) == groups) << out << " " << k;
        }
      }
    }
  }
  expect_read_by_peers(written);
}

TEST_F(TetFiles, ImproveHoldsTagsThroughOperations) {
  std::vector<std::string> written;
  for (unsigned seed = 0; seed < 6; ++seed) {
    SimplexSoup soup = random_domain(seed);
    const std::string in = "in" + std::to_string(seed) + ".msh", out = "out" + in;
    io::write_simplices(directory / in, soup);
    const Ended e = run({"improve", in, "-o", out, "--edge-length", "0.25", "--feature-angle", "40"});
    ASSERT_EQ(e.status, 0) << e.err;
    const SimplexSoup before = io::read_simplices(directory / in),
                      after = io::read_simplices(directory / out);
    expect_positive(after);
    for (std::size_t k = 0; k < 4; ++k) {
      std::set<std::vector<std::int32_t>> a, b;
      for (const auto& [corners, groups] : by_place(before, k)) a.insert(groups);
      for (const auto& [corners, groups] : by_place(after, k)) b.insert(groups);
      if (k == 1) {
        EXPECT_TRUE(std::ranges::includes(b, a)) << out;
      } else {
        EXPECT_EQ(a, b) << out << k;
      }
    }
    written.push_back(out);
    validated(out, 0);
  }
  expect_read_by_peers(written);
}

TEST_F(TetFiles, RequiredEntitiesOfMeditAreWrittenAgain) {
  SimplexSoup soup = kuhn_cube(2);
  soup.simplices[2] = {{}, {4, 5}, {0, io::required_flag}};
  soup.simplices[1] = {{0, 1, 1, 2}, {6, 6}, {io::feature_flag, io::required_flag}};
  soup.simplices[0] = {{0, 26, 2}, {0, 0, 0}, {io::feature_flag, io::required_flag, 3}};
  soup.simplices[3].flags.assign(soup.simplices[3].size(), 0);
  soup.simplices[3].flags[7] = io::required_flag;
  soup.point_tags.assign(soup.points.size(), 0);
  soup.point_tags[5] = 33;
  soup.simplices[2].corners = {soup.simplices[3].corners[0], soup.simplices[3].corners[1],
                               soup.simplices[3].corners[2], soup.simplices[3].corners[4],
                               soup.simplices[3].corners[5], soup.simplices[3].corners[6]};
  io::write_simplices(directory / "in.mesh", soup);
  ASSERT_EQ(run({"improve", "in.mesh", "-o", "out.mesh"}).status, 0);
  const SimplexSoup before = io::read_simplices(directory / "in.mesh"),
                    after = io::read_simplices(directory / "out.mesh");
  const auto flags = [](const SimplexSoup& s, std::size_t k) {
    std::map<std::vector<Place>, int> all;
    for (std::size_t i = 0; i < s.simplices[k].size(); ++i) {
      std::vector<Place> corners;
      for (std::size_t c = 0; c <= k; ++c)
        corners.push_back(s.points[s.simplices[k].corners[(k + 1) * i + c]]);
      std::ranges::sort(corners);
      all[corners] = s.simplices[k].flags.empty() ? 0 : s.simplices[k].flags[i];
    }
    return all;
  };
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(flags(before, k), flags(after, k)) << k;
  EXPECT_EQ(std::ranges::count(after.point_tags, 33), 1);
}

TEST_F(TetFiles, PeriodicMeshesAreRefusedUnlessAskedFor) {
  SimplexSoup soup = kuhn_cube(2);
  soup.periodic = {{2, 5, 6, {}, {{18, 0}, {19, 1}, {20, 2}}}};
  soup.simplices[2] = {{0, 1, 4}, {6}, {}};
  io::write_simplices(directory / "in.msh", soup);
  const Ended refused = run({"improve", "in.msh", "-o", "out.msh"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_TRUE(contains(refused.err, "3 pairs of points")) << refused.err;
  EXPECT_TRUE(contains(refused.err, "--no-periodic")) << refused.err;
  EXPECT_FALSE(exists("out.msh"));
  const Ended done = run({"improve", "in.msh", "-o", "out.msh", "--no-periodic"});
  EXPECT_EQ(done.status, 0);
  EXPECT_TRUE(contains(done.err, "periodic links are dropped, 3 pairs")) << done.err;
}

TEST_F(TetFiles, SidesThatMatchAreTold) {
  SimplexSoup soup = kuhn_cube(3);
  io::write_simplices(directory / "grid.msh", soup);
  EXPECT_TRUE(contains(run({"improve", "grid.msh", "-o", "out.msh"}).err, "(x, y, z)"));
  for (auto& p : soup.points)
    if (p[0] == 1 && p[1] > 0 && p[1] < 1) p[1] += 0.01;
  io::write_simplices(directory / "moved.msh", soup);
  const std::string err = run({"improve", "moved.msh", "-o", "out.msh"}).err;
  EXPECT_FALSE(contains(err, "match (x")) << err;
  EXPECT_FALSE(contains(run({"improve", "grid.msh", "-o", "out.msh", "--no-periodic"}).err, "match"));
}

TEST_F(TetFiles, LockedRegionsMustBeThere) {
  SimplexSoup soup = random_domain(3);
  soup.tag_sets = {{3, 2, {21, 22}}};
  io::write_simplices(directory / "in.msh", soup);
  const Ended e = run({"improve", "in.msh", "-o", "out.msh", "--lock-region", "77"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "--lock-region 77: in.msh has no such tag; it has 1")) << e.err;
  EXPECT_EQ(run({"improve", "in.msh", "-o", "out.msh", "--lock-region", "21"}).status, 0)
      << "a group that shares its tetrahedra with another one";
}

TEST_F(TetFiles, WeldJoinsPointsAtOnePlace) {
  const SimplexSoup whole = kuhn_cube(2);
  SimplexSoup exploded;  // every tetrahedron has points of its own
  for (const std::uint32_t v : whole.simplices[3].corners) {
    exploded.simplices[3].corners.push_back(static_cast<std::uint32_t>(exploded.points.size()));
    exploded.points.push_back(whole.points[v]);
  }
  exploded.simplices[3].tags = whole.simplices[3].tags;
  io::write_simplices(directory / "in.msh", exploded);
  const std::string count = std::to_string(exploded.points.size() - whole.points.size());
  EXPECT_TRUE(
      contains(validated("in.msh", 1)["problems"].dump(), count + " points are at the place of another"));
  EXPECT_TRUE(contains(run({"improve", "in.msh", "-o", "apart.msh"}).err, "--weld 0 joins them"));
  EXPECT_FALSE(contains(run({"improve", "in.msh", "-o", "apart.msh", "--no-weld"}).err, "--weld"));
  const Ended e = run({"improve", "in.msh", "-o", "out.msh", "--weld", "0"});
  EXPECT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(contains(e.err, count + " points were welded")) << e.err;
  EXPECT_EQ(by_place(io::read_simplices(directory / "out.msh"), 3).size(), whole.simplices[3].size());
  EXPECT_EQ(io::read_simplices(directory / "out.msh").points.size(), whole.points.size());
  validated("out.msh", 0);
  for (auto& p : exploded.points) p[0] += 1e-9 * static_cast<double>(&p - exploded.points.data());
  io::write_simplices(directory / "noisy.msh", exploded);
  ASSERT_EQ(run({"improve", "noisy.msh", "-o", "out.msh", "--weld", "1e-6"}).status, 0);
  EXPECT_EQ(io::read_simplices(directory / "out.msh").points.size(), whole.points.size());
}

TEST_F(TetFiles, PointsThatNoElementUsesAreLeftOutAndTold) {
  SimplexSoup soup = kuhn_cube(2);
  soup.points.insert(soup.points.begin(), {9, 9, 9});
  for (auto& block : soup.simplices)
    for (std::uint32_t& v : block.corners) ++v;
  io::write_simplices(directory / "in.msh", soup);
  const Ended e = run({"improve", "in.msh", "-o", "out.msh"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(contains(e.err, "1 points belong to no element; they are not used")) << e.err;
  EXPECT_EQ(io::read_simplices(directory / "out.msh").points.size(), soup.points.size() - 1);
}

TEST_F(TetFiles, OfElementsOfSecondOrderTheCornersAreKept) {
  file("in.msh",
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n10\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 .5 0 0\n"
       "6 .5 .5 0\n7 0 .5 0\n8 0 0 .5\n9 0 .5 .5\n10 .5 0 .5\n$EndNodes\n"
       "$Elements\n1\n1 11 2 3 1 1 2 3 4 5 6 7 8 9 10\n$EndElements\n");
  const Ended e = run({"improve", "in.msh", "-o", "out.msh"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(contains(e.err, "1 elements are of higher order; their corners are kept")) << e.err;
  EXPECT_FALSE(contains(e.err, "belong to no element")) << e.err;
  const SimplexSoup out = io::read_simplices(directory / "out.msh");
  EXPECT_EQ(out.points.size(), 4U);
  EXPECT_EQ(out.simplices[3].tags, std::vector<std::int32_t>{3});
}

TEST_F(TetFiles, TheInputIsNotReplaced) {
  io::write_simplices(directory / "in.msh", kuhn_cube(1));
  const Ended e = run({"improve", "in.msh", "-o", "./in.msh"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "would replace in.msh, which this run reads")) << e.err;
  const Ended bad = run({"improve", "in.msh", "-o", "out.msh", "--edge-length", "-1"});
  EXPECT_EQ(bad.status, 2);
  EXPECT_TRUE(contains(bad.err, "must be above 0")) << bad.err;
}

#endif

TEST_F(TetFiles, ValidateNamesDoubledElements) {
  SimplexSoup soup = kuhn_cube(1);
  for (int i = 0; i < 4; ++i)
    soup.simplices[3].corners.push_back(soup.simplices[3].corners[static_cast<std::size_t>(i)]);
  soup.simplices[3].tags.push_back(0);
  io::write_simplices(directory / "in.vtu", soup);
  EXPECT_TRUE(contains(validated("in.vtu", 1)["problems"].dump(), "1 elements are listed again"));
}

#ifdef MULTIMESH_WITH_TETGEN

/// A closed surface two sides of which are in two groups, which share them.
TEST_F(TetFiles, TetrahedralizeKeepsTrianglesInAllTheirGroups) {
  const SimplexSoup cube = kuhn_cube(2);
  std::map<std::vector<std::uint32_t>, int> count;
  for (std::size_t t = 0; t < cube.simplices[3].size(); ++t)
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
      std::vector<std::uint32_t> face;
      for (std::size_t c = 0; c < 4; ++c)
        if (c != left_out) face.push_back(cube.simplices[3].corners[4 * t + c]);
      std::ranges::sort(face);
      ++count[face];
    }
  SimplexSoup surface;
  surface.points = cube.points;
  for (const auto& [face, n] : count) {
    if (n != 1) continue;
    surface.simplices[2].corners.insert(surface.simplices[2].corners.end(), face.begin(), face.end());
    const bool on_low_x = std::ranges::all_of(face, [&](auto v) { return cube.points[v][0] == 0; });
    const bool on_low_z = std::ranges::all_of(face, [&](auto v) { return cube.points[v][2] == 0; });
    surface.simplices[2].tags.push_back(on_low_x ? 12 : on_low_z ? 13 : 5);
  }
  surface.groups = {{2, 5, "wall"}, {2, 7, "inlet"}, {2, 8, "cold"}};
  surface.tag_sets = {{2, 12, {5, 7}}, {2, 13, {5, 8}}};
  for (const auto version : {io::MshVersion::v2_2, io::MshVersion::v4_1}) {
    io::write_simplices(directory / "in.msh", surface, {.msh_version = version});
    ASSERT_EQ(run({"tetrahedralize", "in.msh", "-o", "out.msh"}).status, 0);
    const SimplexSoup out = io::read_simplices(directory / "out.msh");
    EXPECT_EQ(by_place(out, 2), by_place(surface, 2));
    for (const auto& group : surface.groups)
      EXPECT_NE(std::ranges::find(out.groups, group), out.groups.end()) << group.name;
  }
}

/// Two cubes that touch at a point or along an edge; curves, interfaces and held points are groups with
/// names.
TEST_F(TetFiles, TetrahedralizeTagsAllAndItsOutputIsValid) {
  const auto cube = [](double x, double y, double z, int first) {
    std::string text;
    for (int i = 0; i < 8; ++i)
      text += "v " + std::to_string(x + (i & 1)) + " " + std::to_string(y + (i >> 1 & 1)) + " " +
              std::to_string(z + (i >> 2)) + "\n";
    for (const auto& f :
         {std::array{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}}) {
      text += "f";
      for (const int v : f) text += " " + std::to_string(first + v);
      text += "\n";
    }
    return text;
  };
  file("point.obj", cube(0, 0, 0, 0) + cube(1, 1, 1, 8));
  file("edge.obj", cube(0, 0, 0, 0) + cube(1, 1, 0, 8));
  file("apart.obj", cube(0, 0, 0, 0) + cube(3, 0, 0, 8));
  std::vector<std::string> written;
  for (const char* name : {"point", "edge", "apart"})
    for (const char* option : {"--ascii", "--msh2"}) {
      const std::string out = std::string(name) + option + ".msh";
      const Ended e =
          run({"tetrahedralize", std::string(name) + ".obj", "-o", out, option, "--feature-angle", "40"});
      ASSERT_EQ(e.status, 0) << e.err;
      const SimplexSoup soup = io::read_simplices(directory / out);
      expect_positive(soup);
      EXPECT_LE(soup.simplices[0].size(), 2U) << "no point twice";
      EXPECT_GE(soup.simplices[1].size(), 23U);
      EXPECT_EQ(soup.notes.doubled, 0U);
      validated(out, 0);
      written.push_back(out);
    }
  expect_read_by_peers(written);
}

#endif

}  // namespace
}  // namespace multimesh::tools::test
