// SPDX-License-Identifier: BSD-3-Clause
// insert: surfaces in any state become faces of tetrahedra.
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

/// A tetrahedron with its right angle at (x,x,x).
std::string corner_obj(double x) {
  const auto p = [&](double a, double b, double c) {
    return "v " + std::to_string(x + a) + " " + std::to_string(x + b) + " " + std::to_string(x + c) + "\n";
  };
  return p(0, 0, 0) + p(2, 0, 0) + p(0, 2, 0) + p(0, 0, 2) + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
}

class InsertCommand : public ProgramTest {};

TEST_F(InsertCommand, CrossingBodiesOfTwoFilesBecomeRegions) {
  file("one.obj", corner_obj(0));
  file("two.obj", corner_obj(0.25));
  for (const char* out : {"out.msh", "out.mesh", "out.vtu"}) {
    const Ended e = run({"insert", "one.obj", "two.obj", "-o", out, "--report", "r.json"});
    ASSERT_EQ(e.status, 0) << out << ": " << e.err;
    const Json j = Json::parse(content("r.json"));
    EXPECT_EQ(j["insertion"]["regions"], 4) << "outside, one, two, both";
    EXPECT_EQ(j["insertion"]["points_not_rounded"], 0);
    EXPECT_EQ(run({"validate", out}).status, 0);
    ASSERT_EQ(run({"info", out, "--report", "i.json"}).status, 0);
    const Json m = Json::parse(content("i.json"))["meshes"];
    EXPECT_EQ(m["quality"]["inverted_tetrahedra"], 0);
    EXPECT_EQ(m["tetrahedra"]["euler_characteristic"], 1) << "a box";
    EXPECT_EQ(m["regions"].size(), 4U);
    double both = 2;
    for (const Json& r : m["regions"]) both = std::min(both, r["volume"].get<double>());
    EXPECT_NEAR(both, 1.25 * 1.25 * 1.25 / 6, 1e-9);  // x, y, z > 1/4, and x + y + z < 2
  }
}

TEST_F(InsertCommand, NamesOfFilesAndGroupsAreThoseOfPatches) {
  file("plate.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\ng left\nf 1 2 3\ng right\nf 2 4 3\n");
  file("one.obj", corner_obj(0));
  ASSERT_EQ(run({"insert", "plate.obj", "one.obj", "-o", "out.msh", "--ascii"}).status, 0);
  const std::string text = content("out.msh");
  for (const char* name : {"\"left\"", "\"right\"", "\"one\"", "\"outside\""})
    EXPECT_TRUE(contains(text, name)) << name;
}

TEST_F(InsertCommand, SaysWhatItDropsAndRefuses) {
  file("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 1\nf 1 2 3\nf 1 2 4\n");
  const Ended e = run({"insert", "flat.obj", "-o", "out.msh"});
  EXPECT_EQ(e.status, 0) << e.err;
  EXPECT_TRUE(contains(e.err, "1 triangles have no area")) << e.err;
  file("line.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n");
  EXPECT_EQ(run({"insert", "line.obj", "-o", "none.msh"}).status, 1);
  EXPECT_EQ(run({"insert", "flat.obj", "-o", "flat.obj"}).status, 1);
  EXPECT_EQ(run({"insert", "flat.obj", "-o", "none.msh", "--max-points", "1"}).status, 1);
  EXPECT_EQ(run({"insert", "flat.obj"}).status, 2);
  EXPECT_FALSE(exists("none.msh"));
}

}  // namespace
}  // namespace multimesh::tools::test
