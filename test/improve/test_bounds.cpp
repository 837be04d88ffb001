// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "multimesh/algorithms/improvement/amips.hpp"
#include "multimesh/algorithms/improvement/bounds.hpp"

namespace multimesh::improvement {
namespace {

constexpr double pi = std::numbers::pi;

double number(std::mt19937& random) {
  return static_cast<double>(random()) / 0x1p32;
}

TEST(Bounds, AreThreeForTheRegularTetrahedron) {
  EXPECT_NEAR(least_amips_over(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0.5, std::sqrt(3) / 2, 0)), 3, 1e-14);
  EXPECT_NEAR(least_amips_at_dihedral(std::acos(1.0 / 3)), 3, 1e-14);
  EXPECT_NEAR(least_amips_at_corner(pi / 3), 3, 1e-14);
  EXPECT_NEAR(least_amips_at_dihedral(3), 3, 1e-14);
  EXPECT_NEAR(least_amips_at_corner(2), 3, 1e-14);
  EXPECT_EQ(least_amips_over(Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)), INFINITY);
}

TEST(Bounds, NoTetrahedronOverATriangleIsBetterAndOneAttainsIt) {
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i) {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(number(random), 0.01 + number(random), 0);
    const double bound = least_amips_over(a, b, c);
    for (int j = 0; j < 500; ++j) {
      const Vec3 d(4 * number(random) - 2, 4 * number(random) - 2, 2 * number(random));
      EXPECT_GE(amips(a, b, c, d), bound * (1 - 1e-12));
    }
    const double squares = b.squared_norm() + c.squared_norm() + (b - c).squared_norm();
    const Vec3 best = (a + b + c) / 3 + Vec3(0, 0, std::sqrt(2 * squares / 9));
    EXPECT_NEAR(amips(a, b, c, best), bound, 1e-9 * bound);
  }
}

TEST(Bounds, NoTetrahedronInASmallDihedralAngleIsBetterAndOneAttainsIt) {
  std::mt19937 random(2);
  for (const double phi : {0.02, 0.1, 0.5, 1.0}) {
    const double bound = least_amips_at_dihedral(phi);
    const auto at = [&](double angle, double r, double z) {
      return Vec3(r * std::cos(angle), r * std::sin(angle), z);
    };
    for (int j = 0; j < 5000; ++j) {
      const double angle = phi * number(random);
      const double q =
          amips(Vec3(0, 0, 0), Vec3(0, 0, 1), at(0, 3 * number(random), 4 * number(random) - 1.5),
                at(angle, 3 * number(random), 4 * number(random) - 1.5));
      EXPECT_GE(q, bound * (1 - 1e-12));
    }
    const double s = std::sin(phi / 2), r = std::sqrt(1 / (1 + s * s));
    EXPECT_NEAR(amips(Vec3(0, 0, -0.5), Vec3(0, 0, 0.5), at(0, r, 0), at(phi, r, 0)), bound, 1e-9 * bound);
  }
}

TEST(Bounds, NoTriangleInASmallCornerIsBetter) {
  std::mt19937 random(3);
  for (const double phi : {0.02, 0.1, 0.5}) {
    const double bound = least_amips_at_corner(phi);
    for (int j = 0; j < 5000; ++j) {
      const double angle = phi * number(random), x = 0.1 + number(random), y = 0.1 + number(random);
      EXPECT_GE(
          least_amips_over(Vec3(0, 0, 0), Vec3(x, 0, 0), Vec3(y * std::cos(angle), y * std::sin(angle), 0)),
          bound * (1 - 1e-12));
    }
  }
}

}  // namespace
}  // namespace multimesh::improvement
