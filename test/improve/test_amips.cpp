// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <random>

#include "multimesh/algorithms/improvement/amips.hpp"
#include "multimesh/algorithms/improvement/workspace.hpp"
#include "multimesh/geometry/orient3d.hpp"
#include "multimesh/permutation.hpp"

namespace multimesh::improvement {
namespace {

class Random {
 public:
  Vec3 point() { return {number(), number(), number()}; }
  double number() { return static_cast<double>(random_()) / 0x1p31 - 1; }

 private:
  std::mt19937 random_{7};
};

// By its definition: the Jacobian from the regular tetrahedron.
double by_jacobian(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  Eigen::Matrix3d regular, edges;
  regular << 1, 0.5, 0.5, 0, std::sqrt(3) / 2, std::sqrt(3) / 6, 0, 0, std::sqrt(2.0 / 3);
  for (int i = 0; i < 3; ++i)
    edges.row(i) << b[std::size_t(i)] - a[std::size_t(i)], c[std::size_t(i)] - a[std::size_t(i)],
        d[std::size_t(i)] - a[std::size_t(i)];
  const Eigen::Matrix3d j = edges * regular.inverse();
  return (j.transpose() * j).trace() / std::pow(j.determinant(), 2.0 / 3);
}

TEST(Amips, IsThreeForTheRegularTetrahedron) {
  const Vec3 a(1, 1, 1), b(-1, 1, -1), c(1, -1, -1), d(-1, -1, 1);
  const bool positive = orient3d(a.data(), b.data(), c.data(), d.data()) > 0;
  EXPECT_NEAR(positive ? amips(a, b, c, d) : amips(b, a, c, d), 3, 1e-14);
}

TEST(Amips, IsWhatItsDefinitionSays) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = random.point(), b = random.point(), c = random.point(), d = random.point();
    const double q = amips(a, b, c, d);
    if (!std::isfinite(q)) {
      EXPECT_LE(orient3d(a.data(), b.data(), c.data(), d.data()), 0);
      continue;
    }
    EXPECT_NEAR(q / by_jacobian(a, b, c, d), 1, 1e-9);
    EXPECT_NEAR(std::cbrt(cubed_amips(a, b, c, d)), q, 1e-14 * q);
    EXPECT_GE(q, 3);
  }
}

TEST(Amips, IsTheSameForAllEvenPermutations) {
  Random random;
  int even = 0;
  for (int i = 0; i < 20; ++i) {
    const Vec3 p[4] = {random.point(), random.point(), random.point(), random.point()};
    const double q = amips(p[0], p[1], p[2], p[3]);
    for (std::uint8_t c = 0; c < 24; ++c) {
      const Permutation s{c};
      const double r = amips(p[s[0]], p[s[1]], p[s[2]], p[s[3]]);
      const bool same = std::isfinite(q) == std::isfinite(r);
      even += same;
      if (same && std::isfinite(q)) {
        EXPECT_NEAR(r / q, 1, 1e-12);
      }
    }
  }
  EXPECT_EQ(even, 20 * 12);
}

TEST(Amips, DoesNotDependOnScale) {
  Random random;
  const Vec3 a(0, 0, 0), b(1, 0.25, 0), c(0.5, 1, 0.125), d(0.25, 0.5, 1);
  const double q = amips(a, b, c, d);
  for (const double s : {0x1p-900, 0x1p-300, 0x1p-40, 0x1p60, 0x1p250, 0x1p900}) {
    EXPECT_EQ(amips(s * a, s * b, s * c, s * d), q) << s;
    const AmipsDerivatives f = cubed_amips_derivatives(s * a, s * b, s * c, s * d);
    const AmipsDerivatives g = cubed_amips_derivatives(a, b, c, d);
    EXPECT_DOUBLE_EQ(f.value, g.value);
    EXPECT_TRUE((f.gradient * s).isApprox(g.gradient, 1e-12)) << s;
  }
}

TEST(Amips, IsInfiniteForFlatAndInverted) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(1, 1, 0), e(0, 0, -1);
  EXPECT_EQ(amips(a, b, c, d), INFINITY);
  EXPECT_EQ(amips(a, b, c, e), INFINITY);
  EXPECT_EQ(amips(a, a, a, a), INFINITY);
  EXPECT_EQ(cubed_amips_derivatives(a, b, c, e).value, INFINITY);
  EXPECT_EQ(cubed_amips_derivatives(a, b, c, e).gradient, Eigen::Vector3d(0, 0, 0));
}

TEST(Amips, GradientAndHessianAreThoseOfFiniteDifferences) {
  Random random;
  int tested = 0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 a = random.point(), b = random.point(), c = random.point(), d = random.point();
    const AmipsDerivatives f = cubed_amips_derivatives(a, b, c, d);
    if (!(f.value < 30 * 30 * 30)) continue;
    ++tested;
    const double h = 1e-5;
    for (int k = 0; k < 3; ++k) {
      Vec3 step{};
      step[std::size_t(k)] = h;
      const AmipsDerivatives ahead = cubed_amips_derivatives(a + step, b, c, d);
      const AmipsDerivatives behind = cubed_amips_derivatives(a - step, b, c, d);
      const double size = 1 + f.hessian.norm();
      EXPECT_NEAR((ahead.value - behind.value) / (2 * h), f.gradient[k], 1e-5 * size);
      EXPECT_TRUE(((ahead.gradient - behind.gradient) / (2 * h) - f.hessian.col(k)).norm() < 1e-4 * size);
    }
    EXPECT_TRUE(f.hessian.isApprox(f.hessian.transpose(), 1e-12));
  }
  EXPECT_GT(tested, 40);
}

TEST(Quality, IsFiniteJustForExactlyPositiveTetrahedra) {
  // Flat in floating point, but not quite.
  const Vec3 a(12, 12, 12), b(24, 24, 24), c(0.5, 0.5, 3), on(0.1, 0.1, 7);
  const Vec3 above(0.1, std::nextafter(0.1, 1), 7), below(0.1, std::nextafter(0.1, 0), 7);
  EXPECT_EQ(quality(a, b, c, on), INFINITY);
  const double q = quality(a, b, c, above), r = quality(a, b, c, below);
  EXPECT_NE(q < INFINITY, r < INFINITY);
  EXPECT_LE(std::min(q, r), flat);
}

// Else swaps of tetrahedra that are almost flat can go round and round.
TEST(Quality, DoesNotDependOnTheOrderOfTheCorners) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> x(-1, 1);
  int almost_flat = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<Vec3, 4> p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = Vec3(x(random), x(random), x(random));
    p[3] = 0.3 * p[0] + 0.5 * p[1] + 0.2 * p[2];  // in their plane but for rounding
    const double q = quality(p[0], p[1], p[2], p[3]);
    if (!std::isfinite(q)) continue;
    ++almost_flat;
    EXPECT_EQ(quality(p[1], p[0], p[3], p[2]), q);
    EXPECT_EQ(quality(p[2], p[3], p[0], p[1]), q);
    EXPECT_EQ(quality(p[0], p[2], p[3], p[1]), q);
    EXPECT_EQ(quality(p[1], p[2], p[0], p[3]), q);
  }
  EXPECT_GT(almost_flat, 300);
}

}  // namespace
}  // namespace multimesh::improvement
