// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/geometry/orient3d.hpp"

#include <cmath>
#include <optional>

#include "multimesh/geometry/exact_sum.hpp"
#include "multimesh/geometry/orient2d.hpp"

namespace multimesh {

namespace {

using Sum = detail::ExactSum<3>;

/// Adds the determinant with these rows.
void add_determinant(Sum& sum, const double* u, const double* v, const double* w) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add({u[i], v[j], w[k]});
    sum.subtract({u[i], v[k], w[j]});
  }
}

struct Row {
  Row(const double* p, const double* origin)
      : x(p[0] - origin[0]), y(p[1] - origin[1]), z(p[2] - origin[2]) {}
  explicit Row(const double* p) : x(p[0]), y(p[1]), z(p[2]) {}
  double x, y, z;
};

/// The sign of the determinant of rows that are differences, rounded; nothing where that could be wrong.
std::optional<int> filtered(const Row& u, const Row& v, const Row& w) {
  constexpr double rounding = 7.771561172376103e-16;  // (7 + 56 e) e, e = 2^-53
  constexpr double underflow = 1e-300;                // far above what products lose below the normal doubles
  const double xy = u.x * v.y, yx = u.y * v.x, yz = v.x * w.y, zy = v.y * w.x, zx = w.x * u.y, xz = w.y * u.x;
  const double det = w.z * (xy - yx) + u.z * (yz - zy) + v.z * (zx - xz);
  const double size = std::abs(w.z) * (std::abs(xy) + std::abs(yx)) +
                      std::abs(u.z) * (std::abs(yz) + std::abs(zy)) +
                      std::abs(v.z) * (std::abs(zx) + std::abs(xz));
  const double bound = rounding * size + underflow * (1 + std::abs(u.z) + std::abs(v.z) + std::abs(w.z));
  if (!std::isfinite(bound) || !(std::abs(det) > bound)) return std::nullopt;
  return det > 0 ? 1 : -1;
}

}  // namespace

int orient3d(const double* a, const double* b, const double* c, const double* d) {
  if (const auto sign = filtered(Row(b, a), Row(c, a), Row(d, a))) return *sign;
  Sum sum;  // of the faces' determinants
  add_determinant(sum, b, c, d);
  add_determinant(sum, a, d, c);
  add_determinant(sum, a, b, d);
  add_determinant(sum, a, c, b);
  return sum.sign();
}

int orient_against(const double* n, const double* a, const double* b, const double* c) {
  if (const auto sign = filtered(Row(b, a), Row(c, a), Row(n))) return *sign;
  Sum sum;
  add_determinant(sum, b, c, n);
  add_determinant(sum, c, a, n);
  add_determinant(sum, a, b, n);
  return sum.sign();
}

int orientation_of_facet(int dimension, const Vec3* p, const Vec3& normal) {
  return dimension == 2 ? orient_against(normal.data(), p[0].data(), p[1].data(), p[2].data())
                        : orient3d(p[0].data(), p[1].data(), p[2].data(), p[3].data());
}

bool collinear(const double* a, const double* b, const double* c) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const double p[2] = {a[i], a[j]}, q[2] = {b[i], b[j]}, r[2] = {c[i], c[j]};
    if (orient2d(p, q, r) != 0) return false;
  }
  return true;
}

}  // namespace multimesh
