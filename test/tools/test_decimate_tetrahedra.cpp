// SPDX-License-Identifier: BSD-3-Clause
// multimesh decimate of a file of tetrahedra.
#include "program.hpp"
#include "two_boxes.hpp"

namespace multimesh::tools::test {
namespace {

class DecimateTetrahedra : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    file("boxes.mesh", two_boxes());
  }
  Ended decimate(const Arguments& more, const std::string& out = "out.msh",
                 const std::string& in = "boxes.mesh") const {
    Arguments all{"decimate", in, "-o", out};
    all.insert(all.end(), more.begin(), more.end());
    return run(all);
  }
};

TEST_F(DecimateTetrahedra, KeepsWhatTheReportSays) {
  for (const Arguments& improve : {Arguments{}, Arguments{"--improve"}}) {
    Arguments options{"--ratio", "0.3", "--feature-angle", "40", "--report", "r.json"};
    options.insert(options.end(), improve.begin(), improve.end());
    const Ended e = decimate(options);
    ASSERT_EQ(e.status, 0) << e.err;
    const Json r = json("r.json"), read = info("out.msh");
    EXPECT_TRUE(r["target_reached"].get<bool>()) << e.err;
    EXPECT_LE(r["faces"]["after"].get<double>(), 0.3 * r["faces"]["before"].get<double>() + 1);
    EXPECT_EQ(r["after"]["surface"]["faces"], read["meshes"]["surface"]["faces"]);
    EXPECT_LT(r["after"]["tetrahedra"]["tetrahedra"], r["before"]["tetrahedra"]["tetrahedra"]);
    for (const char* key : {"components", "euler_characteristic", "boundary_loops"})
      EXPECT_EQ(r["before"]["surface"][key], r["after"]["surface"][key]) << key;
    for (const Json& region : read["meshes"]["regions"])
      EXPECT_NEAR(region["volume"].get<double>(), 108, 1e-6) << "flat sides and straight edges";
    EXPECT_EQ(r["tetrahedra"].is_null(), improve.empty());
    EXPECT_EQ(run({"validate", "out.msh"}).status, 0);
  }
}

TEST_F(DecimateTetrahedra, SaysWhatKeepsItFromTheTarget) {
  const Ended e = decimate({"--faces", "1", "--feature-angle", "40", "--report", "r.json"});
  EXPECT_EQ(e.status, 0);
  EXPECT_TRUE(contains(e.err, "warning: the target of 1 faces of the surface cannot be reached")) << e.err;
  EXPECT_FALSE(json("r.json")["target_reached"].get<bool>());
}

TEST_F(DecimateTetrahedra, OptionsForTheOtherKindAreRefused) {
  for (const Arguments& o :
       {Arguments{"--lock-seams"}, Arguments{"--lock-boundary"}, Arguments{"--uv-weld", "1e-6"},
        Arguments{"--max-texture-error", "0.1"}, Arguments{"--levels", "0.5"}, Arguments{"--uv-weight", "1"},
        Arguments{"--follow-paths"}, Arguments{"--no-preserve-materials"}, Arguments{"--measure"}}) {
    Arguments all{"--ratio", "0.2"};
    all.insert(all.end(), o.begin(), o.end());
    const Ended e = decimate(all);
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "boxes.mesh: " + o[0])) << e.err;
    EXPECT_FALSE(exists("out.msh"));
  }
  file("grid.obj", grid_obj(3));
  for (const Arguments& o : {Arguments{"--lock-patch", "1"}, Arguments{"--lock-region", "1"},
                             Arguments{"--improve"}, Arguments{"--target-amips", "8"}, Arguments{"--msh2"},
                             Arguments{"--ascii"}, Arguments{"--no-periodic"}}) {
    Arguments all{"--ratio", "0.5"};
    all.insert(all.end(), o.begin(), o.end());
    const Ended e = decimate(all, "out.obj", "grid.obj");
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "grid.obj: " + o[0])) << e.err;
  }
}

TEST_F(DecimateTetrahedra, TellsOfVolumesThatChange) {
  const Ended e = decimate({"--ratio", "0.02"});  // without --feature-angle the corners are cut off
  EXPECT_EQ(e.status, 0);
  EXPECT_TRUE(contains(e.err, "warning: the volume of region 1 has changed by")) << e.err;
}

TEST_F(DecimateTetrahedra, LockedPatchesAndUnknownNamesAreTold) {
  const Ended e = decimate({"--ratio", "0.5", "--lock-patch", "walls"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "--lock-patch walls: no patch has this name")) << e.err;
}

}  // namespace
}  // namespace multimesh::tools::test
