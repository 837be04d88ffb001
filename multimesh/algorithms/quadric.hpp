// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>

namespace multimesh {

/// A sum of weighted squared distances to planes (Garland & Heckbert 1997). Units: weight x length^2.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, x = 0, y = 0, z = 0, c = 0;
  double weight = 0;

  /// weight * (n.p + d)^2 with |n| = 1.
  static Quadric plane(const OpenMesh::Vec3d& n, double d, double weight) {
    return {weight * n[0] * n[0],
            weight * n[0] * n[1],
            weight * n[0] * n[2],
            weight * n[1] * n[1],
            weight * n[1] * n[2],
            weight * n[2] * n[2],
            weight * n[0] * d,
            weight * n[1] * d,
            weight * n[2] * d,
            weight * d * d,
            weight};
  }

  Quadric& operator+=(const Quadric& q) {
    xx += q.xx, xy += q.xy, xz += q.xz, yy += q.yy, yz += q.yz, zz += q.zz;
    x += q.x, y += q.y, z += q.z, c += q.c, weight += q.weight;
    return *this;
  }
  friend Quadric operator+(Quadric p, const Quadric& q) { return p += q; }

  OpenMesh::Vec3d times(const OpenMesh::Vec3d& p) const {
    return {xx * p[0] + xy * p[1] + xz * p[2], xy * p[0] + yy * p[1] + yz * p[2],
            xz * p[0] + yz * p[1] + zz * p[2]};
  }
  double operator()(const OpenMesh::Vec3d& p) const {
    const double value = dot(p, times(p)) + 2 * (x * p[0] + y * p[1] + z * p[2]) + c;
    return value > 0 ? value : 0;
  }
};

}  // namespace multimesh
