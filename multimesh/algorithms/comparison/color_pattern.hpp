// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <numbers>

#include "multimesh/geometry/vector.hpp"

namespace multimesh::comparison {

/// A smooth colour in [0, 1]^3 at every point of space. `x` in diagonals of the bounding box.
///
/// Each channel is 1/2 plus a coarse and a fine wave of amplitude 1/4, along one axis each of two rotated
/// frames; 3 and 16 waves per diagonal. Over the three channels no direction is preferred: a small shift by s
/// changes a channel by 2 pi sqrt((3^2 + 16^2) / 96) s = 10.4 s in the root mean square, whatever its
/// direction.
inline Vec3 color_pattern(const Vec3& x) {
  constexpr double turn = 2 * std::numbers::pi;
  const auto wave = [&](double count, const Vec3& along) {
    return std::sin(turn * count * dot(along, x) / 3) / 4;
  };
  using V = Vec3;  // three times the axes
  return V(0.5 + wave(3, V(2, -2, 1)) + wave(16, V(1, 2, 2)),
           0.5 + wave(3, V(2, 1, -2)) + wave(16, V(-2, 2, -1)),
           0.5 + wave(3, V(1, 2, 2)) + wave(16, V(2, 1, -2)));
}

}  // namespace multimesh::comparison
