// SPDX-License-Identifier: BSD-3-Clause
// Points that a file lists stay where they are, with tags, names and flags, whatever becomes of the
// tetrahedra.
#include <map>
#include <set>

#include "multimesh/io/simplex_reader.hpp"
#include "multimesh/io/simplex_writer.hpp"
#include "test/tools/listed_domain.hpp"
#include "test/tools/program.hpp"

namespace multimesh::tools::test {
namespace {

using io::SimplexSoup;
using Place = std::array<double, 3>;

/// Corners, edges, faces and the inside of a cube have points, in two layers of regions.
SimplexSoup cube_with_points() {
  SimplexSoup soup = kuhn_cube(4);
  auto& tets = soup.simplices[3];
  for (std::size_t t = 0; t < tets.size(); ++t)
    tets.tags[t] = soup.points[tets.corners[4 * t]][0] < 0.5 ? 1 : 2;
  const auto at = [](std::uint32_t x, std::uint32_t y, std::uint32_t z) { return (x * 5 + y) * 5 + z; };
  soup.simplices[0] = {
      {at(0, 0, 0), at(4, 4, 4), at(1, 0, 0), at(0, 2, 3), at(2, 1, 1), at(1, 1, 2), at(3, 2, 2)},
      {1, 1, 2, 2, 3, 3, 2},
      {}};
  soup.groups = {{3, 1, "rock"}, {3, 2, "oil"}, {0, 1, "corner"}, {0, 2, "sensor"}, {0, 3, "well"}};
  return soup;
}

class FixedPoints : public ProgramTest {
 protected:
  /// What is done, and to what.
  std::vector<Arguments> commands() const {
    std::vector<Arguments> all;
#ifdef MULTIMESH_WITH_IMPROVE
    all.push_back({"improve", "--edge-length", "0.2"});
    all.push_back({"remesh", "--length", "0.4", "--feature-angle", "40"});
    all.push_back({"remesh", "--length", "0.15", "--feature-angle", "40", "--iterations", "3"});
#endif
    return all;
  }
  SimplexSoup after(Arguments command, const std::string& in, const std::string& out) const {
    command.insert(command.begin() + 1, {in, "-o", out});
    const Ended e = run(command);
    EXPECT_EQ(e.status, 0) << e.err;
    return io::read_simplices(directory / out);
  }
  static std::map<Place, std::array<int, 2>> points(const SimplexSoup& soup) {
    std::map<Place, std::array<int, 2>> all;
    const auto& block = soup.simplices[0];
    for (std::size_t i = 0; i < block.size(); ++i)
      all[soup.points[block.corners[i]]] = {block.tags.empty() ? 0 : block.tags[i],
                                            block.flags.empty() ? 0 : block.flags[i]};
    return all;
  }
  static std::set<std::string> names(const SimplexSoup& soup) {
    std::set<std::string> all;
    for (const auto& g : soup.groups)
      if (g.dimension == 0) all.insert(g.name + " " + std::to_string(g.tag));
    return all;
  }
};

TEST_F(FixedPoints, OfGmshFilesKeepTagsAndNames) {
  const bool has_meshio = std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") == 0;
  const SimplexSoup soup = cube_with_points();
  io::write_simplices(directory / "in.msh", soup);
  for (const Arguments& command : commands()) {
    SCOPED_TRACE(command[0] + command[2]);
    const SimplexSoup out = after(command, "in.msh", "out.msh");
    EXPECT_NE(out.simplices[3].size(), soup.simplices[3].size());
    EXPECT_EQ(points(out), points(soup));
    EXPECT_EQ(names(out), names(soup));
    EXPECT_EQ(info("out.msh")["meshes"]["fixed_points"], soup.simplices[0].size());
    if (!has_meshio) continue;
    const std::string script = "/usr/bin/python3 '" MULTIMESH_TEST_DATA "/../points_by_meshio.py' ";
    EXPECT_EQ(std::system(
                  ("cd '" + directory.string() + "' && " + script + "in.msh out.msh >log.txt 2>&1").c_str()),
              0);
  }
}

// Corners and RequiredVertices.
TEST_F(FixedPoints, OfMeditFilesKeepFlagsAndTags) {
  SimplexSoup soup = cube_with_points();
  soup.groups.clear();
  const std::uint8_t both = io::feature_flag | io::required_flag;
  soup.simplices[0].flags = {io::feature_flag,  io::feature_flag,  io::required_flag,
                             io::required_flag, io::required_flag, both,
                             io::required_flag};
  io::write_simplices(directory / "in.mesh", soup);
  const auto before = points(io::read_simplices(directory / "in.mesh"));
  ASSERT_EQ(before.size(), soup.simplices[0].size());
  for (const Arguments& command : commands()) {
    SCOPED_TRACE(command[0] + command[2]);
    EXPECT_EQ(points(after(command, "in.mesh", "out.mesh")), before);
  }
}

}  // namespace
}  // namespace multimesh::tools::test
