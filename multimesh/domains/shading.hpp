// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/domains/textured_triangles.hpp"

namespace multimesh {

/// What is stored of a triangle's normals; the normals themselves are recomputed when needed.
enum ShadingBits : std::uint8_t {
  /// Bit i: the edge from corner i to the next is hard; its two triangles have different normals there.
  hard_edges = 7,
  /// The normals point to the back of the triangle.
  normals_behind = 8,
  /// All three corners have one normal: the triangle alone, or a polygon that it is part of, is shaded
  /// flat.
  flat_shaded = 16,
};

/// Computes TexturedTriangles::shading from the normals of a file. `corners`: \#F, into `normals`; -1: none.
/// An edge of two triangles is hard if at either end their normals differ by more than 0.5 degrees. Other
/// edges are not hard; a corner without a normal, or with one of no length, makes none hard. Cost: sorting of
/// the edges at positions with several normals.
std::vector<std::uint8_t> shading(const TexturedTriangles& surface, std::span<const Vec3> normals,
                                  std::span<const std::array<std::int32_t, 3>> corners);

}  // namespace multimesh
