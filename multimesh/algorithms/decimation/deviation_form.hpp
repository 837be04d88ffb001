// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/geometry/vector.hpp"

namespace multimesh::decimation {

/// x'Ax, x a displacement in space. Unit: area.
struct PositionForm {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

  /// weight (n.x)^2
  static PositionForm plane(const Vec3& n, double weight) {
    const Vec3 m = n * weight;
    return {m[0] * n[0], m[0] * n[1], m[0] * n[2], m[1] * n[1], m[1] * n[2], m[2] * n[2]};
  }
  /// weight |x|^2
  static PositionForm point(double weight) { return {weight, 0, 0, weight, 0, weight}; }

  void add(const PositionForm& f, double sign) {
    xx += sign * f.xx, xy += sign * f.xy, xz += sign * f.xz;
    yy += sign * f.yy, yz += sign * f.yz, zz += sign * f.zz;
  }
  PositionForm operator+(const PositionForm& f) const {
    PositionForm sum = *this;
    sum.add(f, 1);
    return sum;
  }
  PositionForm operator-(const PositionForm& f) const {
    PositionForm difference = *this;
    difference.add(f, -1);
    return difference;
  }
  Vec3 times(const Vec3& x) const {
    return {xx * x[0] + xy * x[1] + xz * x[2], xy * x[0] + yy * x[1] + yz * x[2],
            xz * x[0] + yz * x[1] + zz * x[2]};
  }
  double operator()(const Vec3& x) const { return dot(x, times(x)); }
  double trace() const { return xx + yy + zz; }
};

/// The minimizer of x'Ax + 2 f.x; 0 if A is singular.
inline Vec3 minimum(const PositionForm& a, const Vec3& f) {
  const double xx = a.yy * a.zz - a.yz * a.yz, xy = a.xz * a.yz - a.xy * a.zz, xz = a.xy * a.yz - a.xz * a.yy;
  const double yy = a.xx * a.zz - a.xz * a.xz, yz = a.xy * a.xz - a.xx * a.yz, zz = a.xx * a.yy - a.xy * a.xy;
  const double determinant = a.xx * xx + a.xy * xy + a.xz * xz, trace = a.trace();
  if (!(determinant > 1e-20 * trace * trace * trace)) return {0, 0, 0};
  return PositionForm{xx, xy, xz, yy, yz, zz}.times(f) / -determinant;
}

/// 2 x'My + y'Sy, x a displacement in space and y one in the texture: the terms that a PositionForm lacks to
/// be a form in both.
struct TextureForm {
  double xu = 0, xv = 0, yu = 0, yv = 0, zu = 0, zv = 0;
  double uu = 0, uv = 0, vv = 0;

  void add(const TextureForm& f, double sign) {
    xu += sign * f.xu, xv += sign * f.xv, yu += sign * f.yu, yv += sign * f.yv;
    zu += sign * f.zu, zv += sign * f.zv, uu += sign * f.uu, uv += sign * f.uv, vv += sign * f.vv;
  }
  TextureForm operator+(const TextureForm& f) const {
    TextureForm sum = *this;
    sum.add(f, 1);
    return sum;
  }
  TextureForm operator-(const TextureForm& f) const {
    TextureForm difference = *this;
    difference.add(f, -1);
    return difference;
  }
  /// M y
  Vec3 mixed(const Vec2& y) const {
    return {xu * y[0] + xv * y[1], yu * y[0] + yv * y[1], zu * y[0] + zv * y[1]};
  }
  /// M' x
  Vec2 mixed(const Vec3& x) const {
    return {xu * x[0] + yu * x[1] + zu * x[2], xv * x[0] + yv * x[1] + zv * x[2]};
  }
  /// S y
  Vec2 times(const Vec2& y) const { return {uu * y[0] + uv * y[1], uv * y[0] + vv * y[1]}; }
  double operator()(const Vec3& x, const Vec2& y) const { return 2 * dot(x, mixed(y)) + dot(y, times(y)); }
};

/// x'Ax + 2 b.x + c, x the displacement from a vertex: squared distances from planes that need not pass
/// through it. In single precision, so for a surface of about size 1: it is only ever added to, and used
/// where exactness does not matter.
class PlanesForm {
 public:
  void add_plane(const Vec3& n, double weight) {
    const PositionForm f = PositionForm::plane(n, weight);
    add(f.xx, f.xy, f.xz, f.yy, f.yz, f.zz);
  }
  PositionForm quadratic() const { return {a_[0], a_[1], a_[2], a_[3], a_[4], a_[5]}; }
  Vec3 linear() const { return {b_[0], b_[1], b_[2]}; }
  double operator()(const Vec3& x) const { return quadratic()(x) + 2 * dot(linear(), x) + c_; }

  /// The same planes, relative to a vertex that has moved by x.
  void move(const Vec3& x) {
    const Vec3 b = linear() + quadratic().times(x);
    c_ = static_cast<float>((*this)(x));
    for (std::size_t i = 0; i < 3; ++i) b_[i] = static_cast<float>(b[i]);
  }
  void merge(const PlanesForm& f) {
    for (std::size_t i = 0; i < 6; ++i) a_[i] += f.a_[i];
    for (std::size_t i = 0; i < 3; ++i) b_[i] += f.b_[i];
    c_ += f.c_;
  }

 private:
  template <class... Entries>
  void add(Entries... entries) {
    std::size_t i = 0;
    ((a_[i++] += static_cast<float>(entries)), ...);
  }

  float a_[6] = {}, b_[3] = {}, c_ = 0;
};

}  // namespace multimesh::decimation
