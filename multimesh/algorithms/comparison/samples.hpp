// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "multimesh/algorithms/comparison/corners.hpp"

namespace multimesh::comparison {

/// A point of a surface.
struct Sample {
  Index triangle;
  std::array<double, 3> barycentric;
};

/// `count` points, uniform over the area: the area is divided into `count` equal parts, triangle after
/// triangle, and each part gets one point. The same seed gives the same points on every machine. Ordered by
/// triangle; none if there is no area.
std::vector<Sample> sample(const TexturedTriangles& surface, std::size_t count, std::uint64_t seed);

}  // namespace multimesh::comparison
