// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <bit>
#include <cstdint>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "io_fixture.hpp"
#include "multimesh/io/simplex_reader.hpp"
#include "multimesh/io/simplex_soup.hpp"
#include "multimesh/io/simplex_writer.hpp"

namespace multimesh::io::test {

inline std::vector<std::uint64_t> bits(const std::vector<std::array<double, 3>>& points) {
  std::vector<std::uint64_t> result;
  for (const auto& p : points)
    for (const double x : p) result.push_back(std::bit_cast<std::uint64_t>(x));
  return result;
}

/// Two tetrahedra in two regions, with an interface, boundary edges and two corners; point 5 is unused.
///
///        3
///      / | \.
///     0--|--2--4     0123 in region 7, 1234 in the second; point 5 is elsewhere
///      \ | /
///        1
inline SimplexSoup small_soup(std::int32_t second_region = 9) {
  SimplexSoup soup;
  soup.points = {{0, 0, 0}, {1, 0, 0.1}, {0, 1, 1.0 / 3}, {0, 0, 1}, {1, 1, 1e-300}, {-7.5, 2e9, 3}};
  soup.simplices[3] = {{0, 1, 2, 3, 1, 2, 3, 4}, {7, second_region}, {}};
  soup.simplices[2] = {{1, 2, 3, 0, 1, 2, 0, 3, 1}, {3, 8, 4}, {}};
  soup.simplices[1] = {{0, 1, 1, 2}, {11, 12}, {}};
  soup.simplices[0] = {{0, 4}, {1, 2}, {}};
  soup.groups = {{3, 7, "rock"}, {2, 3, "inter face"}, {1, 11, "edge"}};
  return soup;
}

/// Any finite doubles as points, any different simplices without repeated vertices, tags of a few values, the
/// lowest of which is given.
inline SimplexSoup random_soup(unsigned seed, std::int32_t lowest_tag = 0) {
  std::mt19937_64 random(seed);
  SimplexSoup soup;
  for (int i = 0; i < 40; ++i) {
    std::array<double, 3> p{};
    for (double& x : p) {
      do x = std::bit_cast<double>(random());
      while (!std::isfinite(x));
    }
    soup.points.push_back(p);
  }
  std::vector<std::uint32_t> firsts(40);
  std::iota(firsts.begin(), firsts.end(), 0U);
  for (std::uint32_t k = 0; k < 4; ++k) {
    std::ranges::shuffle(firsts, random);
    for (std::uint64_t n = random() % 30; n > 0; --n) {
      for (std::uint32_t c = 0; c <= k; ++c) soup.simplices[k].corners.push_back((firsts[n] + 7 * c) % 40);
      soup.simplices[k].tags.push_back(lowest_tag + static_cast<std::int32_t>(random() % 4));
    }
  }
  soup.simplices[3].corners.insert(soup.simplices[3].corners.end(), {0, 1, 2, 3});
  soup.simplices[3].tags.push_back(5);
  return soup;
}

inline void expect_same_simplices(const SimplexSoup& a, const SimplexSoup& b) {
  EXPECT_EQ(bits(a.points), bits(b.points));
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(a.simplices[k].corners, b.simplices[k].corners) << k;
    EXPECT_EQ(a.simplices[k].tags, b.simplices[k].tags) << k;
  }
}

/// A file name and the options with which it is written.
struct Form {
  std::string name;
  SimplexWriteOptions options;
};

inline const std::vector<Form> volume_forms = {{"t22.msh", {MshVersion::v2_2, false}},
                                               {"b22.msh", {MshVersion::v2_2, true}},
                                               {"t41.msh", {MshVersion::v4_1, false}},
                                               {"b41.msh", {MshVersion::v4_1, true}},
                                               {"a.mesh", {}},
                                               {"t.vtu", {MshVersion::v4_1, false}},
                                               {"b.vtu", {MshVersion::v4_1, true}}};

inline const std::vector<Form> surface_forms = {{"a.off", {}},
                                                {"t.ply", {.binary = false}},
                                                {"b.ply", {.binary = true}},
                                                {"t.stl", {.binary = false}},
                                                {"b.stl", {.binary = true}},
                                                {"a.obj", {}}};

/// The result of a reader must be consistent, whatever the input was.
inline void expect_valid(const SimplexSoup& soup) {
  for (std::size_t k = 0; k < 4; ++k) {
    const auto& block = soup.simplices[k];
    ASSERT_EQ(block.corners.size(), (k + 1) * block.size());
    ASSERT_TRUE(block.flags.empty() || block.flags.size() == block.size());
    for (const std::uint32_t v : block.corners) ASSERT_LT(v, soup.points.size());
  }
  ASSERT_TRUE(soup.point_tags.empty() || soup.point_tags.size() == soup.points.size());
  for (const auto& link : soup.periodic)
    for (const auto& pair : link.points)
      ASSERT_TRUE(pair[0] < soup.points.size() && pair[1] < soup.points.size());
}

}  // namespace multimesh::io::test
