// SPDX-License-Identifier: BSD-3-Clause
// info, validate and tetrahedralize on files with tetrahedra, end to end.
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

constexpr const char* cube_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

// Two tetrahedra of two regions on one face, which is listed, with a listed edge of it.
constexpr const char* two_regions_msh =
    "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n2\n2 7 \"wall\"\n3 1 "
    "\"water\"\n$EndPhysicalNames\n"
    "$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 1 1 1\n$EndNodes\n"
    "$Elements\n4\n1 4 2 1 1 1 2 3 4\n2 4 2 2 2 2 3 4 5\n3 2 2 7 7 2 3 4\n4 1 2 9 9 2 3\n$EndElements\n";

class TetrahedraCommands : public ProgramTest {
 protected:
  Json validated(const std::string& in, int status) const {
    const Ended e = run({"validate", in, "--json"});
    EXPECT_EQ(e.status, status) << e.err;
    return e.out.empty() ? Json() : Json::parse(e.out);
  }
};

TEST_F(TetrahedraCommands, InfoTellsEveryMesh) {
  file("in.msh", two_regions_msh);
  const Json j = info("in.msh");
  EXPECT_EQ(j["contents"]["tetrahedra"], 2);
  EXPECT_EQ(j["contents"]["groups"].size(), 2U);
  const Json& m = j["meshes"];
  EXPECT_EQ(m["tetrahedra"]["vertices"], 5);
  EXPECT_EQ(m["tetrahedra"]["edges"], 9);
  EXPECT_EQ(m["tetrahedra"]["faces"], 7);
  EXPECT_EQ(m["tetrahedra"]["euler_characteristic"], 1);
  EXPECT_EQ(m["regions"].size(), 2U);
  EXPECT_NEAR(m["regions"][0]["volume"].get<double>(), 1.0 / 6, 1e-12);
  EXPECT_EQ(m["surface"]["faces"], 7);
  EXPECT_EQ(m["patches"], (Json{{{"tag", 0}, {"triangles", 6}}, {{"tag", 7}, {"triangles", 1}}}));
  EXPECT_EQ(m["curves"]["edges"], 3) << "where the interface meets the boundary";
  const Ended lines = run({"info", "in.msh"});
  EXPECT_EQ(lines.status, 0);
  EXPECT_TRUE(contains(lines.out, "2 tetrahedra")) << lines.out;
}

TEST_F(TetrahedraCommands, InfoTakesTrianglesOfAnyFormat) {
  file("in.msh",
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n3\n1 0 0 0\n2 1 0 0\n3 0 1 0\n$EndNodes\n"
       "$Elements\n1\n1 2 2 1 1 1 2 3\n$EndElements\n");
  EXPECT_EQ(info("in.msh")["meshes"]["surface"]["faces"], 1);
}

TEST_F(TetrahedraCommands, ValidateAcceptsWhatIsRight) {
  file("in.msh", two_regions_msh);
  file("cube.obj", cube_obj);
  for (const char* in : {"in.msh", "cube.obj"}) {
    const Json j = validated(in, 0);
    EXPECT_EQ(j["valid"], true) << j;
    EXPECT_TRUE(j["problems"].empty()) << j;
  }
}

TEST_F(TetrahedraCommands, ValidateTellsWhatIsWrong) {
  std::string reversed = two_regions_msh;
  const std::string second = "2 4 2 2 2 2 3 4 5";
  reversed.replace(reversed.find(second), second.size(), "2 4 2 2 2 3 2 4 5");
  file("reversed.msh", reversed);
  EXPECT_TRUE(contains(validated("reversed.msh", 1)["problems"].dump(), "oriented against"));
  file("three.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  EXPECT_TRUE(contains(validated("three.obj", 1)["problems"].dump(), "three or more triangles"));
  file("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 1 2 4\nf 2 5 4\nf 2 3 5\n");
  EXPECT_EQ(run({"validate", "flat.obj"}).status, 1);
}

TEST_F(TetrahedraCommands, ValidateNamesAFileThatCannotBeRead) {
  file("cut.msh", std::string(two_regions_msh).substr(0, 200));
  const Ended e = run({"validate", "cut.msh"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "cut.msh")) << e.err;
}

#ifdef MULTIMESH_WITH_TETGEN

TEST_F(TetrahedraCommands, FillsAClosedSurfaceInEveryFormat) {
  file("cube.obj", cube_obj);
  for (const char* out : {"out.msh", "out.mesh", "out.vtu"}) {
    const Ended e = run({"tetrahedralize", "cube.obj", "-o", out, "--feature-angle", "40"});
    ASSERT_EQ(e.status, 0) << out << ": " << e.err;
    const Json j = info(out);
    const Json& m = j["meshes"];
    EXPECT_GE(m["tetrahedra"]["tetrahedra"], 5);
    EXPECT_EQ(m["tetrahedra"]["euler_characteristic"], 1);
    EXPECT_EQ(m["quality"]["inverted_tetrahedra"], 0);
    EXPECT_EQ(m["surface"]["faces"], 12) << "its triangles are faces";
    EXPECT_EQ(m["curves"]["edges"], 12);
    EXPECT_EQ(m["curves"]["components"], 12);
    EXPECT_NEAR(m["regions"][0]["volume"].get<double>(), 1, 1e-12);
    EXPECT_EQ(run({"validate", out}).status, 0);
  }
}

TEST_F(TetrahedraCommands, BoundsTheSizeOfTetrahedra) {
  file("cube.obj", cube_obj);
  const Ended e =
      run({"tetrahedralize", "cube.obj", "-o", "out.msh", "--split-surface", "--edge-length", "0.2"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json j = info("out.msh");
  const Json& m = j["meshes"];
  EXPECT_GE(m["tetrahedra"]["tetrahedra"], 1 / (0.2 * 0.2 * 0.2 / 8.4))
      << "the volume by the largest allowed";
  EXPECT_GT(m["surface"]["faces"], 12);
  EXPECT_EQ(m["surface"]["euler_characteristic"], 2);
  EXPECT_NEAR(m["regions"][0]["volume"].get<double>(), 1, 1e-9);
}

TEST_F(TetrahedraCommands, JoinsPointsOfTheSurfaceThatAreEqual) {
  file("soup.obj",
       "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 0 0\nv 0 0 1\nf 1 3 2\nf 5 2 4\nf 2 3 6\nf 3 1 4\n");
  const Ended e = run({"tetrahedralize", "soup.obj", "-o", "out.msh"});
  ASSERT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(contains(e.err, "2 points are at the place of another one")) << e.err;
}

TEST_F(TetrahedraCommands, RefusesSurfacesThatBoundNothing) {
  file("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  // A tetrahedron with a vertex that was pushed through the opposite face of another one.
  file("crossing.obj",
       "v 0 0 0\nv 3 0 0\nv 0 3 0\nv 0 0 3\nv 1 1 -1\nv 2 1 -1\nv 1 2 -1\nv 1 1 1\n"
       "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n");
  for (const char* in : {"open.obj", "crossing.obj"}) {
    const Ended e = run({"tetrahedralize", in, "-o", "out.msh"});
    EXPECT_EQ(e.status, 1) << in;
    EXPECT_TRUE(contains(e.err, in)) << e.err;
    EXPECT_FALSE(exists("out.msh"));
  }
}

TEST_F(TetrahedraCommands, LeavesTheInputAlone) {
  file("cube.obj", cube_obj);
  EXPECT_EQ(run({"tetrahedralize", "cube.obj", "-o", "cube.obj"}).status, 1);
  EXPECT_EQ(content("cube.obj"), cube_obj);
  EXPECT_EQ(run({"tetrahedralize", "cube.obj"}).status, 2) << "no output named";
  EXPECT_EQ(run({"tetrahedralize", "cube.obj", "-o", "x.msh", "--feature-angle", "-5"}).status, 2);
  EXPECT_EQ(run({"tetrahedralize", "cube.obj", "-o", "x.txt"}).status, 1) << "no such format";
}

#ifdef MULTIMESH_WITH_IMPROVE

TEST_F(TetrahedraCommands, ImprovesTetrahedraAndKeepsTheSurface) {
  file("cube.obj", cube_obj);
  ASSERT_EQ(run({"tetrahedralize", "cube.obj", "-o", "in.msh", "--split-surface", "--edge-length", "0.3",
                 "--feature-angle", "40"})
                .status,
            0);
  const Ended e = run({"improve", "in.msh", "-o", "out.msh", "--target-amips", "8", "--json", "report.json"});
  ASSERT_EQ(e.status, 0) << e.err;
  const Json r = json("report.json");
  EXPECT_LE(r["after"]["max_amips"].get<double>(), r["before"]["max_amips"].get<double>());
  EXPECT_EQ(r["target_reached"].get<bool>(), r["after"]["max_amips"].get<double>() <= 8) << r;
  const Json in = info("in.msh"), out = info("out.msh");
  const Json &before = in["meshes"], &after = out["meshes"];
  EXPECT_EQ(after["quality"]["inverted_tetrahedra"], 0);
  EXPECT_NEAR(after["regions"][0]["volume"].get<double>(), 1, 1e-12);
  for (const char* key : {"components", "euler_characteristic", "boundary_loops", "genus"})
    EXPECT_EQ(after["surface"][key], before["surface"][key]) << key;
  for (const char* key : {"components", "end_points"}) EXPECT_EQ(after["curves"][key], before["curves"][key]);
  EXPECT_EQ(run({"validate", "out.msh"}).status, 0);
}

TEST_F(TetrahedraCommands, ImproveRefusesInvertedTetrahedra) {
  // Two tetrahedra on one side of their common face.
  file("in.msh",
       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n5\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n5 0 0 0.5\n"
       "$EndNodes\n$Elements\n2\n1 4 2 1 1 1 2 3 4\n2 4 2 1 1 1 3 2 5\n$EndElements\n");
  const Ended e = run({"improve", "in.msh", "-o", "out.msh"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "in.msh")) << e.err;
  EXPECT_FALSE(exists("out.msh"));
}

#endif

#endif

}  // namespace
}  // namespace multimesh::tools::test
