// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gmpxx.h>

#include <array>

#include "multimesh/exact/point.hpp"

namespace multimesh::exact {

using Rational = mpq_class;
struct RationalPoint : std::array<Rational, 3> {};

/// x / w, in lowest terms as a whole; w > 0. Signs of determinants need no common factors to be found.
struct Homogeneous {
  mpz_class x[3], w;
};
struct Point::Fractions : Homogeneous {};

RationalPoint rational(const Vec3& p);
RationalPoint rational(const Point& p);

inline RationalPoint operator-(const RationalPoint& p, const RationalPoint& q) {
  return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
inline RationalPoint cross(const RationalPoint& u, const RationalPoint& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}
inline Rational dot(const RationalPoint& u, const RationalPoint& v) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

/// The sign of det(b-a, c-a, d-a).
int sign_of_fractions(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace multimesh::exact
