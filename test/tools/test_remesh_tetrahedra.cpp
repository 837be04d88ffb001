// SPDX-License-Identifier: BSD-3-Clause
// multimesh remesh of a file of tetrahedra.
#include "program.hpp"
#include "two_boxes.hpp"

namespace multimesh::tools::test {
namespace {

class RemeshTetrahedra : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    file("boxes.mesh", two_boxes());
  }
  Ended remesh(const Arguments& more, const std::string& out = "out.msh",
               const std::string& in = "boxes.mesh") const {
    Arguments all{"remesh", in, "-o", out};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

TEST_F(RemeshTetrahedra, KeepsWhatTheReportSays) {
  for (const char* length : {"0.7", "1.8"}) {
    const Ended e = remesh({"--length", length, "--feature-angle", "40", "--report", "r.json"});
    ASSERT_EQ(e.status, 0) << e.err;
    const Json r = json("r.json"), read = info("out.msh");
    EXPECT_GT(r["edges_in_range"].get<double>(), 0.9 * r["edges"].get<double>()) << e.err;
    EXPECT_EQ(r["after"]["tetrahedra"]["tetrahedra"], read["meshes"]["tetrahedra"]["tetrahedra"]);
    EXPECT_EQ(r["after"]["surface"]["faces"], read["meshes"]["surface"]["faces"]);
    for (const char* key : {"components", "euler_characteristic", "boundary_loops"})
      EXPECT_EQ(r["before"]["surface"][key], r["after"]["surface"][key]) << key;
    for (const Json& region : read["meshes"]["regions"])
      EXPECT_NEAR(region["volume"].get<double>(), 108, 1e-6);
    EXPECT_EQ(run({"validate", "out.msh"}).status, 0);
  }
}

TEST_F(RemeshTetrahedra, WritesEveryFormat) {
  for (const char* out : {"out.msh", "out.mesh", "out.vtu"}) {
    const Ended e = remesh({"--length", "1.5", "--feature-angle", "40", "--iterations", "2"}, out);
    EXPECT_EQ(e.status, 0) << e.err;
    EXPECT_EQ(info(out)["meshes"]["regions"].size(), 2U);
  }
}

TEST_F(RemeshTetrahedra, OptionsForTheOtherKindAreRefused) {
  for (const Arguments& o :
       {Arguments{"--lock-seams"}, Arguments{"--lock-boundary"}, Arguments{"--uv-weld", "1e-6"},
        Arguments{"--follow-paths"}, Arguments{"--no-preserve-materials"}}) {
    Arguments all{"--length", "1"};
    all.insert(all.end(), o.begin(), o.end());
    const Ended e = remesh(all);
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "boxes.mesh: " + o[0])) << e.err;
    EXPECT_FALSE(exists("out.msh"));
  }
  file("grid.obj", grid_obj(3));
  for (const Arguments& o : {Arguments{"--lock-patch", "1"}, Arguments{"--lock-region", "1"},
                             Arguments{"--msh2"}, Arguments{"--ascii"}, Arguments{"--no-periodic"}}) {
    Arguments all{"--length", "1"};
    all.insert(all.end(), o.begin(), o.end());
    const Ended e = remesh(all, "out.obj", "grid.obj");
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "grid.obj: " + o[0])) << e.err;
  }
}

TEST_F(RemeshTetrahedra, SaysWhatIsWrongWithTheInput) {
  Ended e = remesh({"--length", "1e-4"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "boxes.mesh: ")) << e.err;
  EXPECT_TRUE(contains(e.err, "50000000")) << e.err;
  e = remesh({"--length", "1", "--lock-patch", "walls"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "--lock-patch walls: no patch has this name")) << e.err;
  e = remesh({"--length", "1", "--lock-region", "7"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "--lock-region 7")) << e.err;
  e = remesh({"--length", "1"}, "out.obj");
  EXPECT_EQ(e.status, 1) << e.err;
  EXPECT_FALSE(exists("out.obj"));
}

TEST_F(RemeshTetrahedra, GivesVolumesBack) {
  const Ended e = remesh({"--length", "3"});  // without --feature-angle the corners are rounded
  EXPECT_EQ(e.status, 0);
  EXPECT_FALSE(contains(e.err, "the volume of region")) << e.err;
}

}  // namespace
}  // namespace multimesh::tools::test
