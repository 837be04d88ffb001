// SPDX-License-Identifier: BSD-3-Clause
// multimesh remesh: what it keeps, its report, and what it refuses.
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

class RemeshCommand : public ProgramTest {
 protected:
  Ended remesh(const std::string& in, const Arguments& more, const std::string& out = "out.obj") const {
    Arguments all{"remesh", in, "-o", out};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
  void expect(int status, const std::string& message, const std::string& in, const Arguments& more,
              const std::string& out = "out.obj") const {
    const auto before = names();
    const Ended e = remesh(in, more, out);
    EXPECT_EQ(e.status, status) << e.err;
    EXPECT_TRUE(contains(e.err, message)) << e.err;
    EXPECT_EQ(names(), before);
  }
};

TEST_F(RemeshCommand, KeepsTheTopologyAndReportsIt) {
  const Ended e = remesh(spot(), {"--relative-length", "0.02", "--iterations", "5", "--report", "r.json"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(contains(e.err, "5856 faces -> ")) << e.err;
  const Json r = json("r.json");
  EXPECT_EQ(r["options"]["iterations"], 5);
  EXPECT_GT(r["edges_in_range"].get<double>(), 0.9 * r["edges"].get<double>());
  EXPECT_GT(r["operations"]["collapses"].get<int>(), 0);
  for (const char* key : {"components", "euler_characteristic", "boundary_loops"}) {
    EXPECT_EQ(r["before"]["surface"][key], r["after"]["surface"][key]);
    EXPECT_EQ(r["before"]["texture"][key], r["after"]["texture"][key]);
  }
  EXPECT_EQ(r["before"]["seams"]["junctions"], r["after"]["seams"]["junctions"]);
  EXPECT_EQ(r["before"]["seams"]["curves"], r["after"]["seams"]["curves"]);
  // The file says the same when it is read again.
  const Json again = info("out.obj")["meshes"];
  EXPECT_EQ(again["texture"]["charts"], r["after"]["texture"]["charts"]);
  EXPECT_EQ(again["surface"]["faces"], r["after"]["surface"]["faces"]);
}

TEST_F(RemeshCommand, KeepsMaterialBorders) {
  file("grid.obj", grid_obj(8));
  const Ended e = remesh("grid.obj", {"--length", "0.6", "--iterations", "4"});
  ASSERT_EQ(e.status, 0) << e.err;
  const std::string out = content("out.obj");
  EXPECT_TRUE(contains(out, "usemtl left"));
  EXPECT_TRUE(contains(out, "usemtl right"));
  EXPECT_EQ(info("out.obj")["meshes"]["texture"]["charts"], 2);
}

TEST_F(RemeshCommand, GivesTheSameBytesTwice) {
  ASSERT_EQ(remesh(spot(), {"--relative-length", "0.03", "--iterations", "2", "--quiet"}, "a.obj").status, 0);
  ASSERT_EQ(remesh(spot(), {"--relative-length", "0.03", "--iterations", "2", "--quiet"}, "b.obj").status, 0);
  EXPECT_EQ(content("a.obj"), content("b.obj"));
}

TEST_F(RemeshCommand, ReadsOtherFormats) {
  file("tet.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n");
  const Ended e = remesh("tet.off", {"--length", "0.2", "--feature-angle", "40"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_EQ(info("out.obj")["meshes"]["surface"]["euler_characteristic"], 2);
}

// Before any work: in an instant, whatever the length.
TEST_F(RemeshCommand, RefusesMoreFacesThanAllowed) {
  for (const char* length : {"1e-4", "1e-9", "1e-150", "1e-300"}) {
    expect(1, "--max-faces", spot(), {"--length", length});
    expect(1, "faces, more than 50000000", spot(), {"--length", length});
  }
  expect(1, "give a length of at least", spot(), {"--relative-length", "0.01", "--max-faces", "10000"});
  EXPECT_EQ(remesh(spot(), {"--relative-length", "0.03", "--max-faces", "10000"}).status, 0);
  // A strip without width, whose rim is long.
  file("strip.obj", "v 0 0 0\nv 1000 0 0\nv 1000 1e-9 0\nf 1 2 3\n");
  expect(1, "--max-faces", "strip.obj", {"--length", "1e-6"}, "strip_out.obj");
}

TEST_F(RemeshCommand, TellsWhenTheLengthIsMissed) {
  file("grid.obj", grid_obj(4, false));
  const Ended good = remesh("grid.obj", {"--length", "0.3", "--report", "r.json"});
  ASSERT_EQ(good.status, 0) << good.err;
  EXPECT_FALSE(contains(good.err, "warning: ")) << good.err;
  EXPECT_TRUE(json("r.json")["length_reached"].get<bool>());
  const Ended locked =
      remesh("grid.obj", {"--length", "0.2", "--lock-boundary", "--report", "l.json"}, "l.obj");
  ASSERT_EQ(locked.status, 0) << locked.err;
  EXPECT_TRUE(contains(locked.err, "warning: the length was not reached everywhere")) << locked.err;
  const Json report = json("l.json");
  EXPECT_FALSE(report["length_reached"].get<bool>());
  EXPECT_EQ(report["warnings"].size(), 1U);
  EXPECT_NEAR(report["longest_edge"].get<double>(), 1, 0.5);
}

TEST_F(RemeshCommand, RefusesWrongUse) {
  expect(2, "--length", spot(), {});
  expect(2, "--length", spot(), {"--length", "1", "--relative-length", "0.1"});
  expect(2, "above 0", spot(), {"--length", "-1"});
  expect(2, "--iterations", spot(), {"--length", "1", "--iterations", "0"});
  expect(2, "(0, 180]", spot(), {"--length", "1", "--feature-angle", "200"});
  expect(1, ".obj", spot(), {"--length", "1"}, "out.gltf");
  expect(1, "missing.obj", "missing.obj", {"--length", "1"});
  expect(1, "would replace", spot(), {"--length", "1", "--report", "out.obj"});
}

}  // namespace
}  // namespace multimesh::tools::test
