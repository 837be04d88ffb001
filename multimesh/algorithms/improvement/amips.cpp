// SPDX-License-Identifier: BSD-3-Clause
// With the regular tetrahedron of edge length 1, tr(J^T J) is half the sum of the squared edge lengths, and
// det J is sqrt(2) times the determinant of the edge vectors at a corner; so the energy is N / D^(2/3) with
//   N = 1/2 sum l^2,  D = sqrt(2) det(b-a, c-a, d-a).
// Everything is divided by the longest edge at a first, so that nothing under- or overflows.
#include "multimesh/algorithms/improvement/amips.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace multimesh::improvement {

namespace {

using Vector = Eigen::Vector3d;

constexpr double infinity = std::numeric_limits<double>::infinity();

Eigen::Map<const Vector> eigen(const Vec3& v) {
  return Eigen::Map<const Vector>(v.data());
}

struct Terms {
  Vector u, v, w;  // b-a, c-a, d-a in units of `scale`
  double scale;    // a power of two, so that scaling is exact
  double n, det;   // N, and the determinant; of u, v, w

  Terms(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
      : u(eigen(b) - eigen(a)), v(eigen(c) - eigen(a)), w(eigen(d) - eigen(a)) {
    const double longest =
        std::max({u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff(), w.cwiseAbs().maxCoeff()});
    scale = 1;
    // Squares and cubes of numbers outside of this may leave the range of doubles.
    if (!(longest > 0x1p-100 && longest < 0x1p100) && longest > 0 && std::isfinite(longest)) rescale(longest);
    n = 0.5 * (u.squaredNorm() + v.squaredNorm() + w.squaredNorm() + (u - v).squaredNorm() +
               (v - w).squaredNorm() + (w - u).squaredNorm());
    det = u.cross(v).dot(w);
  }

  void rescale(double longest) {
    const int e = std::ilogb(longest);
    for (Vector* x : {&u, &v, &w})
      for (double& coordinate : *x) coordinate = std::scalbn(coordinate, -e);
    scale = std::scalbn(1.0, e);
  }
};

}  // namespace

double cubed_amips(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Terms t(a, b, c, d);
  if (!(t.det > 0)) return infinity;
  return t.n * t.n * t.n / (2 * t.det * t.det);
}

double amips(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return std::cbrt(cubed_amips(a, b, c, d));
}

// Of E = N^3 / (2 det^2), by its logarithm: with g = d(det)/da / det, where d(det)/da = -(v x w + w x u + u x
// v) is constant in a, and m = dN/da / N, where dN/da = -(u + v + w) and d2N/da2 = 3 I:
//   grad E = E p, p = 3 m - 2 g;  hess E = E (p p^T + 9/N I - 3 m m^T + 2 g g^T).
AmipsDerivatives cubed_amips_derivatives(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Terms t(a, b, c, d);
  AmipsDerivatives out;
  out.value = infinity;
  if (!(t.det > 0)) return out;
  const double e = t.n * t.n * t.n / (2 * t.det * t.det);
  if (!std::isfinite(e)) return out;
  const Vector g = -(t.v.cross(t.w) + t.w.cross(t.u) + t.u.cross(t.v)) / t.det;
  const Vector m = -(t.u + t.v + t.w) / t.n;
  const Vector p = 3 * m - 2 * g;
  out.value = e;
  out.gradient = (e / t.scale) * p;
  out.hessian = e / (t.scale * t.scale) *
                (p * p.transpose() - 3 * (m * m.transpose()) + 2 * (g * g.transpose()) +
                 (9 / t.n) * Eigen::Matrix3d::Identity());
  return out;
}

}  // namespace multimesh::improvement
