// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <array>

#include "multimesh/exact/point.hpp"

namespace multimesh::exact {

using Rational = mpq_class;
struct RationalPoint : std::array<Rational, 3> {};

struct Point::Fractions {
  RationalPoint x;
};

inline RationalPoint rational(const Vec3& p) {
  return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}
inline RationalPoint rational(const Point& p) {
  return p.is_double() ? rational(p.nearest()) : p.fractions()->x;
}

inline RationalPoint operator-(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline Rational dot(const RationalPoint& u, const RationalPoint& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

}  // namespace multimesh::exact
