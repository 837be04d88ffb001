// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "multimesh/geometry/orient3d.hpp"
#include "oracle/big_integer.hpp"

namespace multimesh {
namespace {

using Points = std::array<std::array<double, 3>, 4>;

int sign_of(const Points& p) {
  return orient3d(p[0].data(), p[1].data(), p[2].data(), p[3].data());
}

TEST(Orient3d, HasTheSignOfTheDeterminant) {
  const double o[3] = {0, 0, 0}, x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
  EXPECT_EQ(orient3d(o, x, y, z), 1);
  EXPECT_EQ(orient3d(o, y, x, z), -1);
  EXPECT_EQ(orient3d(o, x, y, x), 0);
  EXPECT_EQ(orient_against(z, o, x, y), 1);
  EXPECT_EQ(orient_against(z, o, y, x), -1);
  EXPECT_EQ(orient_against(x, o, x, y), 0);
}

TEST(Orient3d, SeesOneUlp) {
  const double a[3] = {12, 12, 12}, b[3] = {24, 24, 24}, c[3] = {0.5, 0.5, 3};
  const double on[3] = {0.1, 0.1, 7}, off[3] = {0.1, std::nextafter(0.1, 1), 7};
  EXPECT_EQ(orient3d(a, b, c, on), 0);
  EXPECT_NE(orient3d(a, b, c, off), 0);
  EXPECT_EQ(orient3d(a, b, c, off), -orient3d(b, a, c, off));
}

/// Four points near a plane, as near as doubles allow, of any scale.
Points nearly_coplanar(std::mt19937_64& random) {
  const auto real = [&] { return double(random() >> 11U) / double(std::uint64_t{1} << 52U) - 1; };
  Points p{};
  const int digits = static_cast<int>(random() % 4) == 0 ? 3 : 52;
  for (std::size_t i = 0; i < 3; ++i)
    for (double& x : p[i]) x = std::round(std::ldexp(real(), digits));
  const double s = std::round(8 * real()), t = std::round(8 * real());
  for (std::size_t k = 0; k < 3; ++k) p[3][k] = p[0][k] + s * (p[1][k] - p[0][k]) + t * (p[2][k] - p[0][k]);
  if (random() % 3) {
    double& x = p[random() % 4][random() % 3];
    x = std::nextafter(x, random() % 2 ? 1e30 : -1e30);
  }
  const int exponent = std::array{0, -52, 300, -330, 900, -1060, -1120}[random() % 7];
  for (auto& q : p)
    for (double& x : q) x = std::ldexp(x, exponent);
  return p;
}

TEST(Orient3d, AgreesWithIntegersOfAnySize) {
  std::mt19937_64 random(3);
  std::array<int, 3> seen{};
  for (int i = 0; i < 20000; ++i) {
    const Points p = nearly_coplanar(random);
    const int right = oracle::exact_orientation(p);
    ++seen[static_cast<std::size_t>(right + 1)];
    ASSERT_EQ(sign_of(p), right) << i;
    ASSERT_EQ(sign_of({p[1], p[0], p[2], p[3]}), -right) << i;
    ASSERT_EQ(sign_of({p[3], p[0], p[1], p[2]}), -right) << i;
  }
  for (const int n : seen) EXPECT_GT(n, 1000);
}

TEST(Orient3d, AgreesWithIntegersWhereCoordinatesHaveAllScales) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 5000; ++i) {
    Points p{};
    for (auto& q : p)
      for (double& x : q)
        x = std::ldexp(double(random() % 4096) - 2048, static_cast<int>(random() % 2000) - 1040);
    ASSERT_EQ(sign_of(p), oracle::exact_orientation(p)) << i;
  }
}

// With n = d - a, where that is exact, the direction and the point give the same sign.
TEST(Orient3d, AgainstADirectionIsThatOfAPointInIt) {
  std::mt19937_64 random(9);
  int flat = 0;
  for (int i = 0; i < 5000; ++i) {
    Points p{};
    for (auto& q : p)
      for (double& x : q) x = std::ldexp(double(random() % 9) - 4, 40) + double(random() % 3) - 1;
    if (random() % 2) p[3] = p[random() % 3];
    std::array<double, 3> n{};
    for (std::size_t k = 0; k < 3; ++k) n[k] = p[3][k] - p[0][k];
    const int right = oracle::exact_orientation(p);
    flat += right == 0;
    ASSERT_EQ(orient_against(n.data(), p[0].data(), p[1].data(), p[2].data()), right) << i;
  }
  EXPECT_GT(flat, 1000);
}

TEST(Orient3d, HoldsAtTheEndsOfTheRange) {
  const double least = std::numeric_limits<double>::denorm_min(), most = std::numeric_limits<double>::max();
  EXPECT_EQ(sign_of({{{0, 0, 0}, {least, 0, 0}, {0, least, 0}, {0, 0, least}}}), 1);
  EXPECT_EQ(
      sign_of({{{-most, -most, -most}, {most, most, most}, {least, 0, 0}, {0, least, 0}}}),
      oracle::exact_orientation({{{-most, -most, -most}, {most, most, most}, {least, 0, 0}, {0, least, 0}}}));
  EXPECT_EQ(sign_of({{{-most, 0, 0}, {most, 0, 0}, {0, most, 0}, {0, 0, most}}}), 1);
}

TEST(Orient3d, CollinearIsExact) {
  const double a[3] = {0.25, 0.5, 1}, b[3] = {0.5, 1, 2}, c[3] = {0.125, 0.25, 0.5};
  const double off[3] = {0.125, 0.25, std::nextafter(0.5, 1)};
  EXPECT_TRUE(collinear(a, b, c));
  EXPECT_FALSE(collinear(a, b, off));
}

}  // namespace
}  // namespace multimesh
