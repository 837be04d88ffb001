// SPDX-License-Identifier: BSD-3-Clause
// One surface in every format, plain and packed, through every command that reads surfaces.
#include <cstdlib>

#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/simplex_writer.hpp"
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

constexpr int n = 8;

/// A bumpy disk of 2 n^2 triangles, with tags 3 and 4 in its halves.
io::SimplexSoup disk() {
  io::SimplexSoup soup;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x) soup.points.push_back({1.0 * x, 1.0 * y, 0.25 * ((x * y) % 3)});
  const auto at = [](int x, int y) { return static_cast<std::uint32_t>(y * (n + 1) + x); };
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      soup.simplices[2].corners.insert(
          soup.simplices[2].corners.end(),
          {at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y), at(x + 1, y + 1), at(x, y + 1)});
      soup.simplices[2].tags.insert(soup.simplices[2].tags.end(), {x < n / 2 ? 3 : 4, x < n / 2 ? 3 : 4});
    }
  return soup;
}

std::string points_of(const io::SimplexSoup& soup) {
  std::string text;
  for (const auto& p : soup.points)
    for (const double x : p) text += std::to_string(x) + " ";
  return text;
}

std::string legacy_polydata(const io::SimplexSoup& soup) {
  const auto& corners = soup.simplices[2].corners;
  const std::size_t count = corners.size() / 3;
  std::string text = "# vtk DataFile Version 3.0\na disk\nASCII\nDATASET POLYDATA\nPOINTS " +
                     std::to_string(soup.points.size()) + " float\n" + points_of(soup) + "\nPOLYGONS " +
                     std::to_string(count) + " " + std::to_string(4 * count) + "\n";
  for (std::size_t t = 0; t < count; ++t) {
    text += "3";
    for (std::size_t i = 0; i < 3; ++i) text += " " + std::to_string(corners[3 * t + i]);
    text += "\n";
  }
  return text + "POINT_DATA " + std::to_string(soup.points.size()) + "\nTEXTURE_COORDINATES uv 2 float\n" +
         [&] {
           std::string zeros;
           for (std::size_t i = 0; i < soup.points.size(); ++i) zeros += "0 0 ";
           return zeros;
         }() +
         "\n";
}

/// Of version 5, with a line, and a strip for each row of squares.
std::string strips_polydata(const io::SimplexSoup& soup) {
  std::string points, ends = "0";
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x <= n; ++x)
      points += std::to_string((y + 1) * (n + 1) + x) + " " + std::to_string(y * (n + 1) + x) + " ";
    ends += " " + std::to_string((y + 1) * 2 * (n + 1));
  }
  return "# vtk DataFile Version 5.1\na disk\nASCII\nDATASET POLYDATA\nPOINTS " +
         std::to_string(soup.points.size()) + " float\n" + points_of(soup) +
         "\nLINES 2 3\nOFFSETS vtktypeint64\n0 3\nCONNECTIVITY vtktypeint64\n0 1 2\nTRIANGLE_STRIPS " +
         std::to_string(n + 1) + " " + std::to_string(n * 2 * (n + 1)) + "\nOFFSETS vtktypeint64\n" + ends +
         "\nCONNECTIVITY vtktypeint64\n" + points + "\n";
}

std::string vtp(const io::SimplexSoup& soup) {
  std::string corners, ends, tags;
  for (const auto v : soup.simplices[2].corners) corners += std::to_string(v) + " ";
  for (std::size_t t = 0; t < soup.simplices[2].size(); ++t) {
    ends += std::to_string(3 * t + 3) + " ";
    tags += std::to_string(soup.simplices[2].tags[t]) + " ";
  }
  return "<?xml version='1.0'?><VTKFile type='PolyData' version='1.0' byte_order='LittleEndian'><PolyData>"
         "<Piece NumberOfPoints='" +
         std::to_string(soup.points.size()) + "' NumberOfLines='1' NumberOfPolys='" +
         std::to_string(soup.simplices[2].size()) +
         "'><Points><DataArray type='Float64' NumberOfComponents='3' format='ascii'>" + points_of(soup) +
         "</DataArray></Points><CellData><DataArray type='Int32' Name='tag' format='ascii'>9 " + tags +
         "</DataArray></CellData><Lines><DataArray type='Int32' Name='connectivity' format='ascii'>0 "
         "1</DataArray>"
         "<DataArray type='Int32' Name='offsets' format='ascii'>2</DataArray></Lines>"
         "<Polys><DataArray type='Int32' Name='connectivity' format='ascii'>" +
         corners + "</DataArray><DataArray type='Int32' Name='offsets' format='ascii'>" + ends +
         "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
}

std::string ply_strips(const io::SimplexSoup& soup) {
  std::string text = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(soup.points.size()) +
                     "\nproperty double x\nproperty double y\nproperty double z\nelement tristrips 1\n"
                     "property list int int vertex_indices\nend_header\n";
  for (const auto& p : soup.points)
    text += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
  std::string strip;
  for (int y = 0; y < n; ++y) {
    if (y > 0) strip += " -1";
    for (int x = 0; x <= n; ++x)
      strip += " " + std::to_string((y + 1) * (n + 1) + x) + " " + std::to_string(y * (n + 1) + x);
  }
  return text + std::to_string(n * 2 * (n + 1) + n - 1) + strip + "\n";
}

class SurfaceFormats : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    const io::SimplexSoup soup = disk();
    for (const char* name : {"a.obj", "a.ply", "a.off", "a.stl", "a.msh", "a.vtu", "a.mesh"})
      io::write_simplices(directory / name, soup);
    io::write_simplices(directory / "ascii.stl", soup, {.binary = false});
    std::string stl = content("ascii.stl");
    file("open.stl", stl.substr(0, stl.find("endsolid")));
    file("legacy.vtk", legacy_polydata(soup));
    file("strips.vtk", strips_polydata(soup));
    file("a.vtp", vtp(soup));
    file("strips.ply", ply_strips(soup));
  }

  const std::vector<std::string> all{"a.obj",  "a.ply",    "a.off",      "a.stl",      "a.msh", "a.vtu",
                                     "a.mesh", "open.stl", "legacy.vtk", "strips.vtk", "a.vtp", "strips.ply"};
};

TEST_F(SurfaceFormats, EveryCommandReadsEveryOne) {
  for (const std::string& name : all) {
    SCOPED_TRACE(name);
    const Json j = info(name);
    EXPECT_EQ(j["contents"]["triangles"], 2 * n * n);
    EXPECT_EQ(j["meshes"]["surface"]["euler_characteristic"], 1);
    EXPECT_EQ(j["meshes"]["surface"]["boundary_loops"], 1);
    EXPECT_EQ(j["manifold"]["edges_with_opposite_orientations"], 0);
    EXPECT_EQ(run({"validate", name}).status, 0);
    ASSERT_EQ(decimate(name, "out.obj", {"--ratio", "0.5"}).status, 0);
    EXPECT_LE(info("out.obj")["contents"]["faces"], n * n);
    EXPECT_EQ(run({"remesh", name, "-o", "even.obj", "--length", "1"}).status, 0);
    EXPECT_EQ(run({"compare", name, "out.obj", "--samples", "100"}).status, 0);
  }
}

TEST_F(SurfaceFormats, Packed) {
  for (const std::string& name : all) {
    SCOPED_TRACE(name);
    ASSERT_EQ(std::system(("gzip '" + (directory / name).string() + "'").c_str()), 0);
    EXPECT_EQ(info(name + ".gz")["contents"]["triangles"], 2 * n * n);
    EXPECT_EQ(decimate(name + ".gz", "out.obj", {"--ratio", "0.5"}).status, 0);
  }
}

TEST_F(SurfaceFormats, TagsBecomeGroupsWithABorderBetweenThem) {
  for (const char* name : {"a.msh", "a.vtu", "a.mesh", "a.vtp"}) {
    EXPECT_EQ(info(name)["contents"]["groups"], (Json{"3", "4"})) << name;
    ASSERT_EQ(decimate(name, "out.obj", {"--ratio", "0.3"}).status, 0);
    const io::PolygonSoup out = io::read_mesh(directory / "out.obj");
    for (std::size_t f = 0; f < out.face_count(); ++f)
      for (const auto& c : out.face(f)) {
        const double x = out.positions[static_cast<std::size_t>(c.v)][0];
        const bool left = out.sections[out.face_section[f]].group == "3";
        EXPECT_TRUE(left ? x <= n / 2 + 0.25 : x >= n / 2 - 0.25) << name << " " << x;
      }
  }
}

TEST_F(SurfaceFormats, OtherOutputsAndWhatTheyHaveNoRoomFor) {
  for (const char* name : {"out.ply", "out.off", "out.stl"}) {
    const Ended e = decimate(spot(), name, {"--faces", "600"});
    ASSERT_EQ(e.status, 0) << e.err;
    const bool is_ply = std::string(name) == "out.ply";
    EXPECT_EQ(contains(e.err, "texture coordinates are not written"), !is_ply) << e.err;
    EXPECT_TRUE(contains(e.err, "materials are not written")) << e.err;
    const Json j = info(name);
    EXPECT_EQ(j["contents"]["faces"], 600);
    EXPECT_EQ(j["meshes"]["surface"]["euler_characteristic"], 2);
    EXPECT_EQ(j["meshes"]["surface"]["boundary_loops"], 0);
    EXPECT_EQ(j["meshes"]["texture"].is_null(), !is_ply);
    if (is_ply) {
      EXPECT_EQ(j["meshes"]["texture"]["charts"], info(spot())["meshes"]["texture"]["charts"]);
    }
  }
  EXPECT_EQ(run({"remesh", spot(), "-o", "even.ply", "--relative-length", "0.1"}).status, 0);
  const Ended e = decimate(spot(), "out.glb", {"--faces", "600"});
  EXPECT_EQ(e.status, 1);
  EXPECT_TRUE(contains(e.err, "only OBJ, PLY, OFF and STL files are written")) << e.err;
}

TEST_F(SurfaceFormats, CurvesAloneAreDescribed) {
  // 0---1---2   and a loop 4 5 6; two lines meet the first at 1.
  io::SimplexSoup soup;
  for (int i = 0; i < 7; ++i) soup.points.push_back({1.0 * i, 1.0 * (i % 2), 0});
  soup.simplices[1].corners = {0, 1, 1, 2, 1, 3, 4, 5, 5, 6, 6, 4};
  soup.simplices[1].tags.assign(6, 0);
  file("c.vtk", "# vtk DataFile Version 3.0\nc\nASCII\nDATASET POLYDATA\nPOINTS 7 float\n" + points_of(soup) +
                    "\nLINES 3 12\n3 0 1 2\n2 1 3\n4 4 5 6 4\n");
  for (const char* name : {"c.obj", "c.msh", "c.vtu", "c.mesh"}) io::write_simplices(directory / name, soup);
  for (const char* name : {"c.obj", "c.msh", "c.vtu", "c.mesh", "c.vtk"}) {
    SCOPED_TRACE(name);
    const Json c = info(name)["meshes"]["curves"];
    EXPECT_EQ(c["vertices"], 7);
    EXPECT_EQ(c["edges"], 6);
    EXPECT_EQ(c["curves"], 4);
    EXPECT_EQ(c["ends"], 3);
    EXPECT_EQ(c["junctions"], 1);
    EXPECT_EQ(run({"validate", name}).status, 0);
    const Ended e = decimate(name, "out.obj", {"--ratio", "0.5"});
    EXPECT_EQ(e.status, 1);
    EXPECT_TRUE(contains(e.err, "give a surface")) << e.err;
  }
}

TEST_F(SurfaceFormats, ThatTheSidesOfAPeriodicMeshAreNotKeptIsTold) {
  io::SimplexSoup soup = disk();
  for (auto& p : soup.points) p[2] = 0;
  soup.periodic = {{1, 1, 2, {}, {}}};
  for (std::uint32_t y = 0; y <= n; ++y) {
    soup.periodic[0].points.push_back({y * (n + 1) + n, y * (n + 1)});
    if (y == n) continue;
    for (const std::uint32_t x : {0, n})
      soup.simplices[1].corners.insert(soup.simplices[1].corners.end(),
                                       {y * (n + 1) + x, (y + 1) * (n + 1) + x});
    soup.simplices[1].tags.insert(soup.simplices[1].tags.end(), {1, 2});
  }
  io::write_simplices(directory / "tile.msh", soup);
  const std::string told = "the mesh is periodic ($Periodic, 9 pairs of points)";
  EXPECT_TRUE(contains(decimate("tile.msh", "out.obj", {"--ratio", "0.5"}).err, told));
  EXPECT_TRUE(contains(run({"remesh", "tile.msh", "-o", "out.obj", "--length", "1.5"}).err, told));
}

}  // namespace
}  // namespace multimesh::tools::test
