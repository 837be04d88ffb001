// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

namespace multimesh {

/// A point or vector of N coordinates, in space or the plane. Vec() leaves them open, Vec{} sets them to 0.
template <std::size_t N>
struct Vec : std::array<double, N> {
  Vec() = default;
  template <std::convertible_to<double>... Coordinates>
  requires(sizeof...(Coordinates) == N) constexpr Vec(Coordinates... x)
      : std::array<double, N>{static_cast<double>(x)...} {}
  constexpr Vec(const std::array<double, N>& x) : std::array<double, N>(x) {}

  constexpr Vec& operator+=(const Vec& v) {
    for (std::size_t i = 0; i < N; ++i) (*this)[i] += v[i];
    return *this;
  }
  constexpr Vec& operator-=(const Vec& v) {
    for (std::size_t i = 0; i < N; ++i) (*this)[i] -= v[i];
    return *this;
  }
  constexpr Vec& operator*=(double s) {
    for (double& x : *this) x *= s;
    return *this;
  }
  constexpr Vec& operator/=(double s) {
    for (double& x : *this) x /= s;
    return *this;
  }
  friend constexpr Vec operator+(Vec u, const Vec& v) { return u += v; }
  friend constexpr Vec operator-(Vec u, const Vec& v) { return u -= v; }
  friend constexpr Vec operator-(Vec v) { return v *= -1; }
  friend constexpr Vec operator*(Vec v, double s) { return v *= s; }
  friend constexpr Vec operator*(double s, Vec v) { return v *= s; }
  friend constexpr Vec operator/(Vec v, double s) { return v /= s; }

  /// Coordinate by coordinate.
  friend constexpr Vec min(Vec u, const Vec& v) {
    for (std::size_t i = 0; i < N; ++i) u[i] = std::min(u[i], v[i]);
    return u;
  }
  friend constexpr Vec max(Vec u, const Vec& v) {
    for (std::size_t i = 0; i < N; ++i) u[i] = std::max(u[i], v[i]);
    return u;
  }

  friend constexpr double dot(const Vec& u, const Vec& v) {
    double sum = u[0] * v[0];
    for (std::size_t i = 1; i < N; ++i) sum += u[i] * v[i];
    return sum;
  }
  constexpr double squared_norm() const { return dot(*this, *this); }
  double norm() const { return std::sqrt(squared_norm()); }
  Vec normalized() const { return *this / norm(); }
  /// The unit vector in this direction, however short or long u is; 0 for 0.
  Vec unit_or_zero() const {
    double largest = 0;
    for (const double x : *this) largest = std::max(largest, std::abs(x));
    return largest > 0 ? (*this / largest).normalized() : *this;
  }
};

using Vec2 = Vec<2>;
using Vec3 = Vec<3>;

constexpr Vec3 cross(const Vec3& u, const Vec3& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

/// A point of the plane in space, where z = 0.
constexpr Vec3 in_space(const Vec2& p) {
  return {p[0], p[1], 0};
}

}  // namespace multimesh
