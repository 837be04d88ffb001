// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

#include "test/algorithms/made_surface.hpp"

namespace multimesh::test {

/// Spot, read from the example data: 5856 triangles, 13 charts, 18 junctions of seams.
const TexturedTriangles& spot();

/// The centroid of a triangle.
Vec3 centroid(const TexturedTriangles& surface, std::size_t triangle);

/// Adds a set of texture coordinates, one per corner; triangles of which `has` is false stay without.
void add_uv_set(
    TexturedTriangles& surface, const Unwrap& unwrap,
    const std::function<bool(std::size_t triangle)>& has = [](std::size_t) { return true; });

/// The surface with one set of its texture coordinates as the only one.
TexturedTriangles only_uv_set(const TexturedTriangles& surface, std::size_t set);

/// Moves each position by up to `by` in each coordinate, from a seed; relative to the first edge. Texture
/// coordinates stay.
void jitter(TexturedTriangles& surface, double by, unsigned seed);

/// A height field over the grid of two_charts(), with waves `high`.
TexturedTriangles waves(double high = 1);

/// The cube [0, n]^3, each face a grid of n x n squares.
TexturedTriangles cube(int n);
/// Gives cube(n) six charts, or one: a cross, open along seven of the twelve edges.
void unwrap_to_faces(TexturedTriangles& cube, int n);
void unwrap_to_cross(TexturedTriangles& cube, int n);

}  // namespace multimesh::test
