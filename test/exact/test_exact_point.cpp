// SPDX-License-Identifier: BSD-3-Clause
// Against homogeneous coordinates in integers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "multimesh/error.hpp"
#include "multimesh/exact/point.hpp"

namespace multimesh::exact {
namespace {

__extension__ using Integer = __int128;

/// The point (x/w, y/w, z/w), w > 0.
struct Homogeneous {
  Integer x[3];
  Integer w = 1;
};

struct Both {
  Homogeneous integer;
  Point point;
};

Integer det3(const Integer (&a)[3], const Integer (&b)[3], const Integer (&c)[3]) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/// The sign of det(b-a, c-a, d-a), times the denominators.
int sign(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c, const Homogeneous& d) {
  Integer row[3][3];
  const Homogeneous* other[3] = {&b, &c, &d};
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) row[i][k] = other[i]->x[k] * a.w - a.x[k] * other[i]->w;
  const Integer det = det3(row[0], row[1], row[2]);
  return det > 0 ? 1 : det < 0 ? -1 : 0;
}

class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  Both integer_point(int range = 6) {
    Both p{{}, Point(Vec3(0, 0, 0))};
    Vec3 x{};
    for (std::size_t i = 0; i < 3; ++i) {
      const int value = int(random_() % unsigned(2 * range + 1)) - range;
      p.integer.x[i] = value, x[i] = value;
    }
    p.point = Point(x);
    return p;
  }
  /// Of a line and a plane through integer points.
  Both crossing_point() {
    for (;;) {
      const Both a = integer_point(), b = integer_point(), c = integer_point(), d = integer_point(),
                 e = integer_point();
      Integer way[3], u[3], v[3], from[3];
      for (int k = 0; k < 3; ++k)
        way[k] = b.integer.x[k] - a.integer.x[k], u[k] = d.integer.x[k] - c.integer.x[k],
        v[k] = e.integer.x[k] - c.integer.x[k], from[k] = c.integer.x[k] - a.integer.x[k];
      Integer w = det3(way, u, v), t = det3(from, u, v);
      if (w == 0) {
        EXPECT_THROW((void)crossing(a.point, b.point, c.point, d.point, e.point), UsageError);
        continue;
      }
      if (w < 0) w = -w, t = -t;
      Both p{{}, crossing(a.point, b.point, c.point, d.point, e.point)};
      p.integer.w = w;
      for (int k = 0; k < 3; ++k) p.integer.x[k] = a.integer.x[k] * w + t * way[k];
      return p;
    }
  }
  Both any() { return random_() % 2 ? integer_point() : crossing_point(); }
  double fraction() { return double(random_() % 1025) / 1024; }

 private:
  std::mt19937 random_;
};

TEST(ExactPoint, CrossingsHaveTheirNearestDoubles) {
  Generator generator(1);
  std::size_t fractions = 0;
  for (int i = 0; i < 20000; ++i) {
    const Both p = generator.crossing_point();
    bool is_double = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto n = static_cast<double>(p.integer.x[k]), d = static_cast<double>(p.integer.w);
      EXPECT_EQ(p.point.nearest()[k], n / d);  // rounded once: n and d are exact
      is_double &= std::fma(n / d, d, -n) == 0;
    }
    EXPECT_EQ(p.point.is_double(), is_double);
    fractions += !is_double;
  }
  EXPECT_GT(fractions, 5000U);
}

TEST(ExactPoint, OrientationIsThatOfIntegers) {
  Generator generator(2);
  int zeros = 0;
  for (int i = 0; i < 60000; ++i) {
    const Both a = generator.any(), b = generator.any(), c = generator.any(), d = generator.any();
    const int expected = sign(a.integer, b.integer, c.integer, d.integer);
    EXPECT_EQ(orient3d(a.point, b.point, c.point, d.point), expected);
    zeros += expected == 0;
  }
  EXPECT_GT(zeros, 100);
  EXPECT_GT(decisions().nearest, 0U);
  EXPECT_GT(decisions().fractions, 0U);
}

// Far from the origin, the nearest doubles of points that differ are often the same.
TEST(ExactPoint, OrientationDoesNotChangeWithAShift) {
  Generator generator(3);
  const auto shifted = [](const Vec3& p, double by) { return Point(p + Vec3(by, -by, by / 2)); };
  for (const double by : {0x1p20, 0x1p40, 0x1p49})
    for (int i = 0; i < 3000; ++i) {
      Vec3 p[4][5];
      Point here[4] = {Vec3(), Vec3(), Vec3(), Vec3()}, there[4] = {Vec3(), Vec3(), Vec3(), Vec3()};
      for (int k = 0; k < 4; ++k)
        for (;;) {
          for (Vec3& x : p[k]) x = generator.integer_point().point.nearest();
          const auto& q = p[k];
          if (dot(cross(q[3] - q[2], q[4] - q[2]), q[1] - q[0]) == 0) continue;
          here[k] = crossing(q[0], q[1], q[2], q[3], q[4]);
          there[k] = crossing(shifted(q[0], by), shifted(q[1], by), shifted(q[2], by), shifted(q[3], by),
                              shifted(q[4], by));
          break;
        }
      EXPECT_EQ(orient3d(there[0], there[1], there[2], there[3]),
                orient3d(here[0], here[1], here[2], here[3]));
    }
}

TEST(ExactPoint, PointsOfSegmentsAndPlanesAreInThem) {
  Generator generator(4);
  for (int i = 0; i < 3000; ++i) {
    const Both a = generator.any(), b = generator.any(), c = generator.any(), q = generator.any(),
               r = generator.any();
    const Point on = on_segment(a.point, b.point, generator.fraction());
    EXPECT_EQ(orient3d(a.point, b.point, on, q.point), 0);
    const double u = generator.fraction(), v = generator.fraction();
    const Point in = in_plane(a.point, b.point, c.point, u, v);
    EXPECT_EQ(orient3d(a.point, b.point, c.point, in), 0);
    if (sign(a.integer, b.integer, q.integer, r.integer) != 0) {
      const double t = position_on_segment(on, a.point, b.point);
      EXPECT_TRUE(equal(on_segment(a.point, b.point, t), on));
    }
    if (sign(a.integer, b.integer, c.integer, r.integer) != 0) {
      EXPECT_EQ(position_in_plane(in, a.point, b.point, c.point), (std::array<double, 2>{u, v}));
    }
  }
}

TEST(ExactPoint, DoublesAreEnoughForDyadicPoints) {
  const Point p = on_segment(Vec3(0, 0, 0), Vec3(1, 2, 4), 0.25);
  EXPECT_TRUE(p.is_double());
  EXPECT_EQ(p.nearest(), Vec3(0.25, 0.5, 1));
  EXPECT_EQ(p.bits(), 53U);
  const Point third = crossing(Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1));
  EXPECT_FALSE(third.is_double());
  EXPECT_EQ(third.bits(), 2U);  // (1,1,1)/3
  EXPECT_FALSE(equal(third, Point(third.nearest())));
}

}  // namespace
}  // namespace multimesh::exact
