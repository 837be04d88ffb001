// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/comparison/samples.hpp"
#include "multimesh/spatial/triangle_tree.hpp"

namespace multimesh::comparison {

spatial::TriangleTree tree_in_space(const TexturedTriangles& surface);

std::vector<Vec3> points(const TexturedTriangles& surface, const std::vector<Sample>& samples);

/// Per point its closest point on the surface. Fast if successive points are close to each other.
std::vector<spatial::Nearby> closest(const spatial::TriangleTree& surface, const std::vector<Vec3>& points,
                                     unsigned threads);

/// The positions that some triangle has, by ascending number.
std::vector<Index> used_positions(const TexturedTriangles& surface);

}  // namespace multimesh::comparison
