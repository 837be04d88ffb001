// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/lattice.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "multimesh/error.hpp"

namespace multimesh {

Lattice::Lattice(const std::array<bool, 3>& periodic, const Eigen::Matrix3d& periods) : periodic_(periodic) {
  // Axes that are not periodic: unit vectors across the periods, so that the basis is as good as they are.
  Eigen::Matrix3d basis = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (is_periodic(i)) {
      if (!periods.col(i).allFinite())
        throw InputError(std::string("the period vector along ") + "xyz"[i] + " is not finite");
      periods_.col(i) = basis.col(i) = periods.col(i);
    }
  for (int i = 0; i < 3; ++i) {
    if (is_periodic(i)) continue;
    const Eigen::Vector3d &u = basis.col((i + 1) % 3), &v = basis.col((i + 2) % 3);
    Eigen::Vector3d across = Eigen::Vector3d::Unit(i);
    if (!u.isZero(0) && !v.isZero(0)) {
      across = u.cross(v);
    } else if (const Eigen::Vector3d one = u + v; !one.isZero(0)) {
      if (std::abs(one.normalized()[i]) > 0.9)
        across = Eigen::Vector3d::Unit(u.isZero(0) ? (i + 1) % 3 : (i + 2) % 3);
      across -= one * (across.dot(one) / one.squaredNorm());
    }
    basis.col(i) = across.normalized();
  }
  double size = 1;
  for (int i = 0; i < 3; ++i) size *= basis.col(i).norm();
  if (!(std::abs(basis.determinant()) > 1e-9 * size))
    throw InputError("the period vectors are not linearly independent");
  inverse_ = basis.inverse();
}

LatticeVector Lattice::rounded(const Vec3& displacement) const {
  const Vec3 c = coordinates(displacement);
  LatticeVector v{};
  for (int i = 0; i < 3; ++i)
    if (is_periodic(i))
      v[static_cast<std::size_t>(i)] = static_cast<int>(std::lround(c[static_cast<std::size_t>(i)]));
  return v;
}

std::optional<LatticeVector> Lattice::nearest(const Vec3& displacement, double tolerance) const {
  const Vec3 c = coordinates(displacement);
  for (int i = 0; i < 3; ++i)
    if (is_periodic(i) && !(std::abs(c[static_cast<std::size_t>(i)]) < 1e6)) return std::nullopt;
  const LatticeVector v = rounded(displacement);
  if (!((shift(v) - displacement).norm() <= tolerance)) return std::nullopt;
  return v;
}

namespace {

/// Coefficients of v by basis vectors, and what is left of it across them.
struct Expansion {
  Eigen::VectorXd coefficients;
  Vec3 rest;
};

Expansion expand(const std::vector<Vec3>& basis, const Vec3& v) {
  if (basis.empty()) return {{}, v};
  Eigen::MatrixXd m(3, static_cast<Eigen::Index>(basis.size()));
  for (std::size_t i = 0; i < basis.size(); ++i)
    m.col(static_cast<Eigen::Index>(i)) = Eigen::Vector3d(basis[i].data());
  const Eigen::Vector3d whole(v.data());
  const Eigen::VectorXd coefficients = m.colPivHouseholderQr().solve(whole);
  const Eigen::Vector3d rest = whole - m * coefficients;
  return {coefficients, {rest[0], rest[1], rest[2]}};
}

}  // namespace

// A vector that is no integer combination of the basis takes, less the nearest one, the place of a basis
// vector, which is then asked itself. That divides the volume of the cell by two or more each time.
std::vector<Vec3> lattice_basis(std::span<const Vec3> vectors, double tolerance) {
  std::vector<Vec3> basis, left(vectors.begin(), vectors.end());
  std::stable_sort(left.begin(), left.end(),
                   [](const auto& v, const auto& w) { return v.norm() > w.norm(); });
  for (int steps = 0; !left.empty(); ++steps) {
    if (steps > 1000 + 4 * static_cast<int>(vectors.size()))
      throw InputError("the translations of the periodic links generate no lattice");
    const Vec3 v = left.back();
    left.pop_back();
    const Expansion e = expand(basis, v);
    if (e.rest.norm() > tolerance) {
      basis.push_back(v);
      continue;
    }
    Vec3 nearer{};
    std::size_t largest = 0;
    double most = 0;
    for (std::size_t i = 0; i < basis.size(); ++i) {
      const double c = e.coefficients[static_cast<Eigen::Index>(i)], fraction = c - std::round(c);
      nearer += fraction * basis[i];
      if (std::abs(fraction) > most) most = std::abs(fraction), largest = i;
    }
    if (nearer.norm() <= tolerance) continue;
    std::swap(basis[largest], nearer);
    left.push_back(nearer);
  }
  return basis;
}

std::string name_of(const LatticeVector& v) {
  std::string s;
  for (std::size_t i = 0; i < 3; ++i) {
    if (v[i] == 0) continue;
    if (v[i] < 0) s += '-';
    if (v[i] > 0 && !s.empty()) s += '+';
    if (std::abs(v[i]) > 1) s += std::to_string(std::abs(v[i]));
    s += "xyz"[i];
  }
  return s.empty() ? "0" : s;
}

std::string text_of(const Vec3& p) {
  std::ostringstream s;
  s << '(' << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return s.str();
}

}  // namespace multimesh
