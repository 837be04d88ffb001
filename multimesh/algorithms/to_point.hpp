// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>

#include "multimesh/closest_point.hpp"

namespace multimesh {

/// OpenMesh vectors as points for the closest-point queries.
inline spatial::Point to_point(const OpenMesh::Vec3d& p) {
  return {p[0], p[1], p[2]};
}
inline spatial::Point to_point(const OpenMesh::Vec2d& p) {
  return {p[0], p[1], 0};
}

}  // namespace multimesh
