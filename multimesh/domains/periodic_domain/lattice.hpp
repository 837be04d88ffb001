// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace multimesh {

/// An integer combination of period vectors; 0 along axes that are not periodic.
using LatticeVector = std::array<int, 3>;

inline LatticeVector operator+(const LatticeVector& a, const LatticeVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline LatticeVector operator-(const LatticeVector& a, const LatticeVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

/// Up to three period vectors, each named by an axis: x, y, z.
class Lattice {
 public:
  using Point = Eigen::Vector3d;

  /// `periods`: a column per axis; those of axes that are not periodic are not read.
  /// \throw InputError if the vectors of periodic axes are not finite or not linearly independent
  Lattice(const std::array<bool, 3>& periodic, const Eigen::Matrix3d& periods);

  bool is_periodic(int axis) const { return periodic_[static_cast<std::size_t>(axis)]; }
  /// A column per axis; 0 for those that are not periodic.
  const Eigen::Matrix3d& periods() const noexcept { return periods_; }
  Point shift(const LatticeVector& v) const { return periods_ * Eigen::Vector3d(v[0], v[1], v[2]); }
  /// Coordinates in units of the period vectors. Along axes that are not periodic, some that complete them.
  Point coordinates(const Point& p) const { return inverse_ * p; }
  /// Distance of the planes at which such a coordinate is 0 and 1.
  double height(int axis) const { return 1 / inverse_.row(axis).norm(); }
  /// The same of a combination of coordinates. \pre not 0
  double spacing(const LatticeVector& combination) const {
    return 1 / (Eigen::RowVector3d(combination[0], combination[1], combination[2]) * inverse_).norm();
  }
  /// The lattice vector within `tolerance` of a displacement.
  std::optional<LatticeVector> nearest(const Point& displacement, double tolerance) const;

 private:
  std::array<bool, 3> periodic_;
  Eigen::Matrix3d periods_ = Eigen::Matrix3d::Zero(), inverse_;
};

/// A basis of the lattice that vectors generate, up to three of them; those that are given, if they will do.
/// Vectors shorter than `tolerance` are 0. \throw InputError if they generate no lattice
std::vector<Eigen::Vector3d> lattice_basis(std::span<const Eigen::Vector3d> vectors, double tolerance);

/// "x", "x+y", "2z-x", ...
std::string name_of(const LatticeVector& v);
/// "(0.5, 1, 0)"
std::string text_of(const Eigen::Vector3d& p);

}  // namespace multimesh
