// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/comparison/samples.hpp"
#include "multimesh/spatial/triangle_tree.hpp"

namespace multimesh::comparison {

spatial::TriangleTree tree_in_space(const TexturedTriangles& surface);

std::vector<Vec3> points(const TexturedTriangles& surface, const std::vector<Sample>& samples);

/// The closest point on the surface to each point. Fast if successive points are close to each other.
std::vector<spatial::Nearby> closest(const spatial::TriangleTree& surface, const std::vector<Vec3>& points,
                                     unsigned threads);

/// The positions that are used by a triangle, in ascending order.
std::vector<Index> used_positions(const TexturedTriangles& surface);

}  // namespace multimesh::comparison
