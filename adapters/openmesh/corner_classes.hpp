// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh::openmesh {

/// Per corner, the first corner with the same vertex and equal texture coordinates, by value: -0 equals 0.
/// `vertex` and `texcoord`: per corner, indices below `vertices` and into `values`. Cost: n log k for n
/// corners, k at a vertex; linear where all corners of each vertex have one index.
std::vector<Index> first_equal_corners(std::span<const Index> vertex, Index vertices,
                                       std::span<const Index> texcoord, std::span<const Vec2> values);

}  // namespace multimesh::openmesh
