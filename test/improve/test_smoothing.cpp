// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "multimesh/algorithms/improvement/smoothing.hpp"

namespace multimesh::improvement {
namespace {

/// The faces of the octahedron with these corners, seen from inside.
std::vector<Opposite> octahedron() {
  std::vector<Opposite> faces;
  for (const double x : {1.0, -1.0})
    for (const double y : {1.0, -1.0})
      for (const double z : {1.0, -1.0}) {
        const Vec3 a(x, 0, 0), b(0, y, 0), c(0, 0, z);
        faces.push_back(x * y * z > 0 ? Opposite{a, c, b} : Opposite{a, b, c});
      }
  for (Opposite& o : faces)
    if (!(cubed_amips(Vec3(0, 0, 0), o[0], o[1], o[2]) < INFINITY)) std::swap(o[1], o[2]);
  return faces;
}

TEST(Smoothing, FindsTheMiddleOfAnOctahedron) {
  const auto faces = octahedron();
  std::mt19937 random(1);
  for (int i = 0; i < 50; ++i) {
    Vec3 start;
    for (int k = 0; k < 3; ++k) start[k] = 0.6 * (static_cast<double>(random()) / 0x1p32 - 0.5);
    EXPECT_LT(best_place(start, faces).norm(), 1e-2) << start[0] << ' ' << start[1] << ' ' << start[2];
  }
}

TEST(Smoothing, MovesAlongTheGivenAxesOnly) {
  const Vec3 start(0.2, 0.1, -0.3);
  const Vec3 p = best_place(start, octahedron(), {true, false, true});
  EXPECT_EQ(p[1], start[1]);
  EXPECT_LT(std::abs(p[0]) + std::abs(p[2]), 2e-2);
  EXPECT_EQ(best_place(start, octahedron(), {false, false, false}), start);
}

TEST(Smoothing, StartsAgainFromTheMiddleIfATetrahedronIsInverted) {
  const auto faces = octahedron();
  EXPECT_EQ(worst_quality(Vec3(0.8, 0.8, 0.8), faces, 1e300), INFINITY);
  const Vec3 p = best_place(Vec3(0.8, 0.8, 0.8), faces);
  EXPECT_LT(p.norm(), 2e-2);
  EXPECT_LT(worst_quality(p, faces, 1e300), 200);
}

TEST(Smoothing, WorksOnTinyAndHugeStars) {
  for (const double s : {1e-12, 1e12}) {
    auto faces = octahedron();
    for (Opposite& o : faces)
      for (Vec3& p : o) p *= s;
    EXPECT_LT(best_place(Vec3(0.2 * s, 0.1 * s, -0.3 * s), faces).norm(), 2e-2 * s) << s;
  }
}

}  // namespace
}  // namespace multimesh::improvement
