// SPDX-License-Identifier: BSD-3-Clause
// Normals and vertex colours of a file, in its decimated copy.
#include <cmath>
#include <set>

#include "multimesh/io/obj_reader.hpp"
#include "program.hpp"

namespace multimesh::tools::test {
namespace {

using io::PolygonSoup;
using Vec3 = std::array<double, 3>;

/// A cube of six quads with a normal each, or none; n squares along each edge.
std::string cube_obj(int n, bool normals) {
  std::string v, f;
  int count = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const int side : {0, n}) {
      const int first = count + 1;
      for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j, ++count) {
          const int p[3] = {side, i, j};
          v += "v";
          for (int k = 0; k < 3; ++k) v += ' ' + std::to_string(p[(k + 3 - axis) % 3]);
          v += '\n';
        }
      const auto corner = [&](int i, int j) {
        return ' ' + std::to_string(first + i * (n + 1) + j) +
               (normals ? "//" + std::to_string(2 * axis + (side ? 2 : 1)) : "");
      };
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
          f += "f" + corner(i, j) + (side ? corner(i + 1, j) : corner(i, j + 1)) + corner(i + 1, j + 1) +
               (side ? corner(i, j + 1) : corner(i + 1, j)) + '\n';
    }
  return v + "vn -1 0 0\nvn 1 0 0\nvn 0 -1 0\nvn 0 1 0\nvn 0 0 -1\nvn 0 0 1\n" + f;
}

/// A sphere-like grid over angles without its poles, with radial normals.
std::string barrel_obj(int n) {
  std::string v, vn, f;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double a = 2 * M_PI * i / n, b = M_PI * (0.25 + 0.5 * j / n);
      const Vec3 p{std::sin(b) * std::cos(a), std::sin(b) * std::sin(a), std::cos(b)};
      for (auto* line : {&v, &vn}) {
        *line += line == &v ? "v" : "vn";
        for (const double x : p) *line += ' ' + std::to_string(x);
        *line += '\n';
      }
    }
  const auto corner = [&](int i, int j) {
    const std::string k = std::to_string((i % n) * (n + 1) + j + 1);
    return ' ' + k + "//" + k;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      f += "f" + corner(i, j) + corner(i, j + 1) + corner(i + 1, j + 1) + corner(i + 1, j) + '\n';
  return v + vn + f;
}

class NormalsAndColors : public ProgramTest {
 protected:
  PolygonSoup decimated(const std::string& obj, const char* ratio) {
    file("in.obj", obj);
    const Ended e = decimate("in.obj", "out.obj", {"--ratio", ratio});
    EXPECT_EQ(e.status, 0) << e.err;
    // Nothing else to warn of but that the sheets of the cube are joined.
    const bool is_split = contains(e.err, "vertices at exactly the place of another one are joined");
    EXPECT_EQ(contains(e.err, "warning"), is_split) << e.err;
    EXPECT_EQ(e.err.rfind("warning"), e.err.find("warning")) << e.err;
    return io::read_obj(directory / "out.obj");
  }
};

double angle(const Vec3& a, const Vec3& b) {
  const Vec3 c{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  return std::atan2(std::hypot(c[0], c[1], c[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) * 180 / M_PI;
}

TEST_F(NormalsAndColors, ACubeOfSixSheetsHasSixNormals) {
  for (const char* ratio : {"1", "0.3"}) {
    const PolygonSoup out = decimated(cube_obj(8, true), ratio);
    EXPECT_EQ(std::set<Vec3>(out.normals.begin(), out.normals.end()).size(), 6U);
    EXPECT_EQ(out.normals.size(), 6U);
    for (const auto& c : out.corners) EXPECT_GE(c.vn, 0);
  }
}

TEST_F(NormalsAndColors, WithoutNormalsNoneAreWritten) {
  EXPECT_TRUE(decimated(cube_obj(8, false), "0.3").normals.empty()) << "normals that no face uses";
}

TEST_F(NormalsAndColors, ASmoothSurfaceStaysSmooth) {
  const PolygonSoup out = decimated(barrel_obj(40), "0.3");
  for (const auto& c : out.corners) {
    const Vec3 p = out.positions[static_cast<std::size_t>(c.v)];
    if (std::abs(p[2]) > 0.6) continue;  // near the rims, whose faces are on one side only
    ASSERT_GE(c.vn, 0);
    EXPECT_LT(angle(out.normals[static_cast<std::size_t>(c.vn)], p), 12);
  }
}

TEST_F(NormalsAndColors, ColorsStayWithTheirPositions) {
  file("in.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 0.5 0.25 0.125\nf 1 2 3\nf 1 3 4\n");
  ASSERT_EQ(decimate("in.obj", "out.obj", {"--ratio", "1"}).status, 0);
  const PolygonSoup in = io::read_obj(directory / "in.obj"), out = io::read_obj(directory / "out.obj");
  ASSERT_EQ(out.colors.size(), out.positions.size());
  std::set<std::pair<Vec3, Vec3>> before, after;
  for (std::size_t i = 0; i < 4; ++i) {
    before.emplace(in.positions[i], in.colors[i]);
    after.emplace(out.positions[i], out.colors[i]);
  }
  EXPECT_EQ(before, after);
}

TEST_F(NormalsAndColors, InfoHasNoFeaturesWithoutAnAngle) {
  file("in.obj", cube_obj(2, true));
  EXPECT_TRUE(info("in.obj")["meshes"]["features"].is_null());
}

}  // namespace
}  // namespace multimesh::tools::test
