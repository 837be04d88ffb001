// SPDX-License-Identifier: BSD-3-Clause
// `improve`, end to end.
#include "test/tools/program.hpp"

namespace multimesh::tools::test {
namespace {

#ifdef MULTIMESH_WITH_IMPROVE

class ImproveCommand : public ProgramTest {
 protected:
  static std::string data(const std::string& name) { return MULTIMESH_TEST_DATA "/" + name; }

  /// What no improvement may change, of the mesh in a file.
  Json kept(const std::string& name) const {
    Json kept = info(name)["meshes"]["tetrahedra"];
    for (const char* changes : {"vertices", "edges", "faces", "tetrahedra"}) kept.erase(changes);
    return kept;
  }
  void expect_kept(const std::string& in, const Arguments& more) const {
    Arguments arguments{"improve", in, "-o", "out.msh"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended e = run(arguments);
    ASSERT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(kept("out.msh"), kept(in)) << in;
  }
};

TEST_F(ImproveCommand, KeepsMeshesWhosePointsHaveAnnularLinksWhole) {
  expect_kept(data("mini22.msh"), {"--edge-length", "0.3"});
  expect_kept(data("mini_annulus.msh"), {"--target-amips", "4"});
  expect_kept(data("mini_annulus.msh"), {"--target-amips", "4", "--edge-length", "0.2"});
}

TEST_F(ImproveCommand, InfoDescribesTheMeshInTheFileNotTheCutOne) {
  const Json m = info(data("mini_annulus.msh"))["meshes"]["tetrahedra"];
  EXPECT_EQ(m["euler_characteristic"], 2);
  EXPECT_EQ(m["cavities"], 1);
  EXPECT_EQ(m["components"], 1);
}

TEST_F(ImproveCommand, SaysWhichTargetWasMissed) {
  const Ended e = run({"improve", data("mini_annulus.msh"), "-o", "out.msh", "--edge-length", "0.05",
                       "--target-amips", "3.2", "--max-passes", "1", "--json", "report.json"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json r = json("report.json");
  EXPECT_FALSE(r["target_reached"]);
  EXPECT_EQ(r["edge_lengths"]["target"], 0.05);
  EXPECT_TRUE(contains(e.err, "the target was missed")) << e.err;
  EXPECT_TRUE(r["edge_lengths"]["too_long"] == 0 || contains(e.err, "the edge length was missed")) << e.err;
  EXPECT_EQ(run({"improve", data("mini22.msh"), "-o", "x.msh", "--lock-patch", "wall"}).status, 1);
  const Ended late = run({"improve", data("mini22.msh"), "-o", "late.msh", "--target-amips", "3.1",
                          "--time-limit", "1e-9", "--progress"});
  EXPECT_EQ(late.status, 0);
  EXPECT_TRUE(contains(late.err, "--time-limit")) << late.err;
}

TEST_F(ImproveCommand, MovesTheSurfaceInAnEnvelope) {
  const std::string in = data("mini_annulus.msh");
  const auto improve = [&](const Arguments& more) {
    Arguments arguments{"improve",      in,  "-o",       "out.msh",    "--target-amips", "3.5",
                        "--max-passes", "3", "--report", "report.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  };
  const Ended e = improve({"--relative-envelope", "0.02"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json moved = json("report.json")["envelopes"][0];
  EXPECT_GT(moved["moved"], 0);
  EXPECT_LE(moved["moved"], moved["distance"]);
  EXPECT_LE(moved["moved_from"], moved["distance"]);
  const Json before = info(in)["meshes"]["tetrahedra"], after = info("out.msh")["meshes"]["tetrahedra"];
  EXPECT_EQ(before["euler_characteristic"], after["euler_characteristic"]);
  EXPECT_EQ(before["cavities"], after["cavities"]);
  EXPECT_EQ(improve({"--envelope", "0.1", "--relative-envelope", "0.1"}).status, 2);
  EXPECT_EQ(improve({"--envelope", "0"}).status, 2);
}

#ifdef MULTIMESH_WITH_TETGEN
TEST_F(ImproveCommand, KeepsACavityThatTouchesTheOutside) {
  ASSERT_EQ(run({"tetrahedralize", data("cavity_touch.obj"), "-o", "in.msh"}).status, 0);
  expect_kept("in.msh", {});
  expect_kept("in.msh", {"--target-amips", "5", "--edge-length", "0.2"});
}
#endif

#endif

}  // namespace
}  // namespace multimesh::tools::test
