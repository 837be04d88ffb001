// SPDX-License-Identifier: BSD-3-Clause
// `info` on files drawn by hand, of which every number is known.
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

class Info : public ProgramTest {
 protected:
  Json of(const std::string& obj) const {
    file("in.obj", obj);
    return info("in.obj");
  }
};

void expect_mesh(const Json& m, const std::array<long, 7>& expected) {
  const std::array<const char*, 7> keys = {
      "vertices", "edges", "faces", "components", "euler_characteristic", "boundary_loops", "genus"};
  for (std::size_t i = 0; i < keys.size(); ++i) EXPECT_EQ(m[keys[i]], expected[i]) << keys[i] << "\n" << m;
}

// 4---5---6   Two quads and a triangle-fan polygon; the seam runs along 2-5.
// | A | B |
// 1---2---3
constexpr const char* two_quads =
    "mtllib m.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 2 0\nvt 3 0\nvt 3 1\nvt 2 1\n"
    "g a\nusemtl red\nf 1/1 2/2 5/3 4/4\ng b\nusemtl blue\nf 2/5 3/6 6/7 5/8\n";

TEST_F(Info, TwoQuadsWithASeam) {
  const Json j = of(two_quads);
  const Json& c = j["contents"];
  EXPECT_EQ(c["positions"], 6);
  EXPECT_EQ(c["texcoords"], 8);
  EXPECT_EQ(c["faces"], 2);
  EXPECT_EQ(c["quads"], 2);
  EXPECT_EQ(c["larger_polygons"], 0);
  EXPECT_EQ(c["triangles"], 4);
  EXPECT_EQ(c["materials"], (Json{"blue", "red"}));
  EXPECT_EQ(c["groups"], (Json{"a", "b"}));
  EXPECT_EQ(c["objects"], Json{"thing"});
  EXPECT_EQ(c["material_libraries"], Json{"m.mtl"});
  EXPECT_EQ(j["manifold"]["as_given"], true);
  expect_mesh(j["meshes"]["surface"], {6, 9, 4, 1, 1, 1, 0});
  expect_mesh(j["meshes"]["texture"], {8, 10, 4, 2, 2, 2, 0});
  EXPECT_EQ(j["meshes"]["texture"]["charts"], 2);
  const Json& s = j["meshes"]["seams"];
  EXPECT_EQ(s["edges"], 1);
  EXPECT_EQ(s["curves"], 1);
  EXPECT_EQ(s["ends"], 2);
  EXPECT_EQ(s["junctions"], 0);
}

TEST_F(Info, ThreeTrianglesAtAnEdge) {
  const Json j = of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n");
  const Json& m = j["manifold"];
  EXPECT_EQ(m["as_given"], false);
  EXPECT_EQ(m["edges_with_three_or_more_faces"], 1);
  EXPECT_EQ(m["vertex_copies_made_to_cut_it"], 4);
  expect_mesh(j["meshes"]["surface"], {9, 9, 3, 3, 3, 3, 0});
  EXPECT_TRUE(j["meshes"]["texture"].is_null());
  EXPECT_EQ(j["triangles_without_texcoords"], 3);
}

TEST_F(Info, OppositeOrientations) {
  const Json j = of("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 -1 0\nf 1 2 3\nf 1 2 4\n");
  EXPECT_EQ(j["manifold"]["edges_with_opposite_orientations"], 1);
  EXPECT_EQ(j["manifold"]["triangles_reversed"], 1);
  expect_mesh(j["meshes"]["surface"], {4, 5, 2, 1, 1, 1, 0});
}

TEST_F(Info, PolygonsAndUnusedVertices) {
  const Json j = of("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nv 9 9 9\nf 1 2 3 4 5\n");
  EXPECT_EQ(j["contents"]["positions"], 6);
  EXPECT_EQ(j["contents"]["larger_polygons"], 1);
  expect_mesh(j["meshes"]["surface"], {5, 7, 3, 1, 1, 1, 0});
}

TEST_F(Info, Spot) {
  const Json j = info(spot());
  expect_mesh(j["meshes"]["surface"], {2930, 8784, 5856, 1, 2, 0, 0});
  EXPECT_EQ(j["meshes"]["texture"]["charts"], 13);
  EXPECT_EQ(j["meshes"]["seams"]["junctions"], 18);
}

TEST_F(Info, TheTextHasTheNumbersOfTheJson) {
  const Json j = of(two_quads);
  const Ended e = run({"info", "in.obj"});
  EXPECT_EQ(e.status, 0);
  for (const char* part : {"in.obj", "6 v", "8 vt", "2 quads", "6 vertices, 9 edges, 4 triangles",
                           "8 vertices, 10 edges, 4 triangles", "2 charts", "1 edges in 1 curves"})
    EXPECT_TRUE(contains(e.out, part)) << part << "\n" << e.out;
}

}  // namespace
}  // namespace multimesh::tools::test
