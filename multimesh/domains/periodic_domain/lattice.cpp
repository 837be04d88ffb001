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

std::optional<LatticeVector> Lattice::nearest(const Point& displacement, double tolerance) const {
  const Point c = coordinates(displacement);
  LatticeVector v{};
  for (int i = 0; i < 3; ++i) {
    if (!is_periodic(i)) continue;
    if (!(std::abs(c[i]) < 1e6)) return std::nullopt;
    v[static_cast<std::size_t>(i)] = static_cast<int>(std::lround(c[i]));
  }
  if (!((shift(v) - displacement).norm() <= tolerance)) return std::nullopt;
  return v;
}

namespace {

/// Coefficients of v by basis vectors, and what is left of it across them.
struct Expansion {
  Eigen::VectorXd coefficients;
  Eigen::Vector3d rest;
};

Expansion expand(const std::vector<Eigen::Vector3d>& basis, const Eigen::Vector3d& v) {
  if (basis.empty()) return {{}, v};
  Eigen::MatrixXd m(3, static_cast<Eigen::Index>(basis.size()));
  for (std::size_t i = 0; i < basis.size(); ++i) m.col(static_cast<Eigen::Index>(i)) = basis[i];
  Expansion e{m.colPivHouseholderQr().solve(v), {}};
  e.rest = v - m * e.coefficients;
  return e;
}

}  // namespace

// A vector that is no integer combination of the basis takes, less the nearest one, the place of a basis
// vector, which is then asked itself. That divides the volume of the cell by two or more each time.
std::vector<Eigen::Vector3d> lattice_basis(std::span<const Eigen::Vector3d> vectors, double tolerance) {
  std::vector<Eigen::Vector3d> basis, left(vectors.begin(), vectors.end());
  std::stable_sort(left.begin(), left.end(),
                   [](const auto& v, const auto& w) { return v.norm() > w.norm(); });
  for (int steps = 0; !left.empty(); ++steps) {
    if (steps > 1000 + 4 * static_cast<int>(vectors.size()))
      throw InputError("the translations of the periodic links generate no lattice");
    const Eigen::Vector3d v = left.back();
    left.pop_back();
    const Expansion e = expand(basis, v);
    if (e.rest.norm() > tolerance) {
      basis.push_back(v);
      continue;
    }
    Eigen::Vector3d nearer = Eigen::Vector3d::Zero();
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

std::string text_of(const Eigen::Vector3d& p) {
  std::ostringstream s;
  s << '(' << p[0] << ", " << p[1] << ", " << p[2] << ')';
  return s.str();
}

}  // namespace multimesh
