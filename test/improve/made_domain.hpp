// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <map>
#include <string>
#include <vector>

#include "multimesh/domains/tet_domain.hpp"

namespace multimesh::test {

using Vec3 = Eigen::Vector3d;

/// A box of n^3 cubes, six tetrahedra each, n even, with all kinds of things inside:
///   regions 1 and 2 on both sides of x = 1/2; a sheet, patch 5, at z = 1/2 in region 2; a curve, tag 7,
///   along x = y = 1/n from z = 0 to 1. Patches 11..16 on the sides, 3 on the interface.
/// Coordinates of the box are multiples of 1/n; `map` is applied to them.
struct BoxOptions {
  int n = 4;
  bool sheet = true, regions = true, curve = true;
  Eigen::Matrix3d map = Eigen::Matrix3d::Identity();
  /// Free vertices are moved, one after the other, this part of the way to where a tetrahedron becomes flat.
  double squash = 0.97;
  unsigned seed = 1;
};

struct Box {
  TaggedTetrahedra input;
  BoxOptions options;
  /// Three points of each plane, mapped: those of the sides, then of the interface and of the sheet.
  std::vector<std::array<Vec3, 3>> planes;
  std::vector<Vec3> corners;
};

Box make_box(const BoxOptions& options);

/// What must hold between a domain and its improved version, a sentence for each fault.
class Kept {
 public:
  explicit Kept(const TetDomain& domain);
  std::string fault(const TetDomain& after) const;

 private:
  std::map<TetDomain::Tag, double> volumes_, areas_, lengths_;
  std::vector<long> topology_;
};

/// Of positive orientation, all of them, exactly.
bool all_positive(const TetDomain& domain);
double max_amips(const TetDomain& domain);

}  // namespace multimesh::test
