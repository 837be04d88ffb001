// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cmath>
#include <random>
#include <set>

#include "io_fixture.hpp"
#include "multimesh/io/mesh_reader.hpp"
#include "multimesh/io/obj_reader.hpp"
#include "multimesh/io/obj_writer.hpp"

namespace multimesh::io::test {
namespace {

class RoundTrip : public IoTest {};

template <std::size_t N>
std::vector<std::uint64_t> bits(const std::vector<std::array<double, N>>& points) {
  std::vector<std::uint64_t> result;
  for (const auto& p : points)
    for (const double x : p) result.push_back(std::bit_cast<std::uint64_t>(x));
  return result;
}

void expect_equal(const PolygonSoup& a, const PolygonSoup& b) {
  EXPECT_EQ(bits(a.positions), bits(b.positions));
  EXPECT_EQ(bits(a.texcoords), bits(b.texcoords));
  EXPECT_EQ(bits(a.normals), bits(b.normals));
  EXPECT_EQ(bits(a.colors), bits(b.colors));
  EXPECT_EQ(a.face_begin, b.face_begin);
  EXPECT_EQ(a.corners, b.corners);
  EXPECT_EQ(a.material_libraries, b.material_libraries);
  ASSERT_EQ(a.face_count(), b.face_count());
  for (std::size_t f = 0; f < a.face_count(); ++f)
    ASSERT_EQ(a.sections[a.face_section[f]], b.sections[b.face_section[f]]) << "face " << f;
}

class RandomSoup {
 public:
  explicit RandomSoup(unsigned seed) : random_(seed) {}

  PolygonSoup make() {
    const std::size_t size = 6 + random_() % 60;
    soup_.positions = points<3>(size);
    soup_.texcoords = points<2>(random_() % 50);
    soup_.normals = points<3>(random_() % 50);
    if (random_() % 2) soup_.colors = points<3>(size);
    for (int i = 0; i < 5; ++i) soup_.sections.push_back({name(), name(), name(), name()});
    for (int i = 0; i < 80; ++i) face();
    soup_.material_libraries = {"a b.mtl", "c.mtl"};
    return soup_;
  }

 private:
  /// Any finite double is as likely as any other.
  double number() {
    double x = 0;
    do x = std::bit_cast<double>(random_());
    while (!std::isfinite(x));
    return random_() % 4 ? x : std::round(std::fmod(x, 8));
  }
  template <std::size_t N>
  std::vector<std::array<double, N>> points(std::size_t size) {
    std::vector<std::array<double, N>> result(size);
    for (auto& p : result)
      for (double& x : p) x = number();
    return result;
  }
  std::string name() {
    static const std::vector<std::string> names = {"", "a", "two words", "#1", "x/y\\z"};
    return names[random_() % names.size()];
  }
  std::int32_t index(std::size_t size) { return static_cast<std::int32_t>(random_() % (size + 1)) - 1; }
  void face() {
    std::set<std::int32_t> used;
    const std::size_t size = 3 + random_() % 4;
    while (used.size() < size) {
      const auto v = static_cast<std::int32_t>(random_() % soup_.positions.size());
      if (used.insert(v).second)
        soup_.corners.push_back({v, index(soup_.texcoords.size()), index(soup_.normals.size())});
    }
    soup_.face_begin.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
    soup_.face_section.push_back(static_cast<std::uint32_t>(random_() % soup_.sections.size()));
    soup_.face_line.push_back(0);
  }

  std::mt19937_64 random_;
  PolygonSoup soup_;
};

TEST_F(RoundTrip, RandomSoupsComeBackBitByBit) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const PolygonSoup soup = RandomSoup(seed).make();
    write_obj(directory / "a.obj", soup, {.header = {"made by a test \\"}});
    const PolygonSoup again = read_obj(directory / "a.obj", {1, 1});
    expect_equal(soup, again);
    write_obj(directory / "b.obj", again, {.header = {"made by a test \\"}});
    EXPECT_EQ(content(directory / "a.obj"), content(directory / "b.obj"));
  }
}

TEST_F(RoundTrip, EveryTexturedFileComesBack) {
  const fs::path root = shared("textured");
  if (root.empty()) GTEST_SKIP() << "no shared data";
  std::vector<fs::path> files = files_under(root, ".obj");
  for (const fs::path& file : files_under(root, ".ply")) files.push_back(file);
  for (const fs::path& path : files) {
    SCOPED_TRACE(path);
    const PolygonSoup soup = read_mesh(path);
    write_obj(directory / "a.obj", soup);
    expect_equal(soup, read_obj(directory / "a.obj"));
  }
}

TEST_F(RoundTrip, WithoutNormals) {
  PolygonSoup soup = RandomSoup(1).make();
  write_obj(directory / "a.obj", soup, {.normals = false});
  soup.normals.clear();
  for (auto& corner : soup.corners) corner.vn = -1;
  expect_equal(soup, read_obj(directory / "a.obj", {1, 1}));
}

TEST_F(RoundTrip, StatementsAreWrittenOnlyWhereTheyChange) {
  const fs::path in = file(
      "in.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no q\nusemtl a\nf 1 2 3\nusemtl b\nusemtl a\nf 1 3 4\n");
  write_obj(directory / "out.obj", read_obj(in));
  EXPECT_EQ(content(directory / "out.obj"),
            "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no q\nusemtl a\nf 1 2 3\nf 1 3 4\n");
}

}  // namespace
}  // namespace multimesh::io::test
