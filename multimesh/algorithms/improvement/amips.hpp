// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::improvement {

/// The AMIPS energy of a tetrahedron, tr(J^T J) / det(J)^(2/3), where J takes the regular tetrahedron to it:
/// 3 at best, +infinity if it is inverted or flat in floating point. Invariant under similarities and
/// orientation-preserving renaming of corners; exactly so under scaling by powers of two. Cost: some tens of
/// operations and a cube root. Source: Fu, Liu, Guo, Computing locally injective mappings by advanced MIPS,
/// ACM Trans. Graph. 34 (2015), equation 3, without the factor 1/8 and the second term.
double amips(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Its cube, 27 at best: cheaper by the cube root, for comparisons. Where it is below
/// certainly_positive, orient3d(a,b,c,d) is 1: coordinate differences have a relative error of 2^-53 each,
/// the determinant thus one of at most about 10 * 2^-53 |ab| |ac| |ad|, and a cube of this size means that
/// it is at least 2^-35 times that product.
double cubed_amips(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
inline constexpr double certainly_positive = 1e18;

/// The cubed energy with its derivatives with respect to a, the other corners being held.
struct AmipsDerivatives {
  double value = 0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();  ///< per unit of length
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();   ///< per unit of length squared; symmetric
};

/// \return value +infinity and derivatives of zero if the tetrahedron is inverted or flat in floating point
AmipsDerivatives cubed_amips_derivatives(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

}  // namespace multimesh::improvement
