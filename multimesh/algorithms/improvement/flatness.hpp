// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/geometry/vector.hpp"

namespace multimesh::improvement {

/// What counts as plane and straight: exact signs, or up to the rounding of coordinates, if points at the
/// middle of edges are rounded, too.
struct Flatness {
  bool rounded = false;

  bool coplanar(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) const;
  bool collinear(const Vec3& a, const Vec3& b, const Vec3& c) const;
};

}  // namespace multimesh::improvement
