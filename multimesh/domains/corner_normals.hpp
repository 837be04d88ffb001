// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/textured_surface.hpp"

namespace multimesh {

/// Normals as files store them: a list without repetitions, and three indices per triangle.
struct CornerNormals {
  std::vector<Vec3> normals;  ///< of length 1, each number rounded to 6 decimals
  std::vector<std::array<std::int32_t, 3>> corners;
};

/// The normals of the current surface; triangles and corners are those of surface.triangles(). All faces
/// around a vertex that nothing separates share one normal there: the mean of their normals, weighted by
/// their angles at the vertex. Faces are separated by boundaries, hard edges, and edges of more than 5
/// degrees between triangles that were shaded flat: the diagonal of a flat polygon is not hard, but it may
/// have become an edge like the others. The normal is on the side of each triangle on which the input had it.
/// 0 0 1 where no face has an area. Cost: linear. Source: Thuermer & Wuethrich, Computing vertex normals from
/// polygonal facets, J. Graphics Tools 3(1), 1998.
CornerNormals corner_normals(const TexturedSurface& surface);

}  // namespace multimesh
