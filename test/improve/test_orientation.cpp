// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "adapters/predicates/orientation.hpp"

namespace multimesh {
namespace {

TEST(Orientation, HasTheSignOfTheDeterminant) {
  const double o[3] = {0, 0, 0}, x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, z[3] = {0, 0, 1};
  EXPECT_EQ(orient3d(o, x, y, z), 1);
  EXPECT_EQ(orient3d(o, y, x, z), -1);
  EXPECT_EQ(orient3d(o, x, y, x), 0);
}

TEST(Orientation, SeesOneUlp) {
  const double a[3] = {12, 12, 12}, b[3] = {24, 24, 24}, c[3] = {0.5, 0.5, 3};
  const double on[3] = {0.1, 0.1, 7}, off[3] = {0.1, std::nextafter(0.1, 1), 7};
  EXPECT_EQ(orient3d(a, b, c, on), 0);
  EXPECT_NE(orient3d(a, b, c, off), 0);
  EXPECT_EQ(orient3d(a, b, c, off), -orient3d(b, a, c, off));
}

TEST(Orientation, OfIntegersIsThatOfIntegerArithmetic) {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    std::int64_t p[4][3];
    double q[4][3];
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 3; ++k) q[j][k] = static_cast<double>(p[j][k] = static_cast<int>(random() % 7) - 3);
    std::int64_t m[3][3];
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) m[j][k] = p[j + 1][k] - p[0][k];
    const std::int64_t det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                             m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                             m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    EXPECT_EQ(orient3d(q[0], q[1], q[2], q[3]), (det > 0) - (det < 0));
  }
}

TEST(Orientation, CollinearIsExact) {
  const double a[3] = {0.25, 0.5, 1}, b[3] = {0.5, 1, 2}, c[3] = {0.125, 0.25, 0.5};
  const double off[3] = {0.125, 0.25, std::nextafter(0.5, 1)};
  EXPECT_TRUE(collinear(a, b, c));
  EXPECT_FALSE(collinear(a, b, off));
}

}  // namespace
}  // namespace multimesh
