// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/geometry/vector.hpp"

namespace multimesh {

/// Triangles by corners, as files store them: a position and optionally a texture coordinate per corner.
struct TexturedTriangles {
  struct Corner {
    std::int32_t position = 0;
    std::int32_t texcoord = -1;  ///< -1: none; a triangle has three or none
  };
  /// Further sets of texture coordinates: a light map, for instance.
  struct UvSet {
    std::vector<Vec2> texcoords;
    std::vector<std::array<std::int32_t, 3>> corners;  ///< \#F; -1: none; a triangle has three or none
  };

  std::vector<Vec3> positions;  ///< \#V
  std::vector<Vec2> texcoords;  ///< \#VT
  std::vector<std::array<Corner, 3>> triangles;
  /// A label per triangle, or empty: materials, for instance. Borders between labels are kept as curves.
  std::vector<Index> labels;
  std::vector<UvSet> more_uv_sets;  ///< sets 1, 2, ...; set 0 is in `triangles`
  std::vector<Vec3> colors;         ///< \#V in [0, 1], or empty
  /// Per triangle the shading by its original normals, or empty: see shading.hpp.
  std::vector<std::uint8_t> shading;

  std::size_t uv_sets() const noexcept { return 1 + more_uv_sets.size(); }
  /// Texture coordinates of a set: 0 is the first one.
  const std::vector<Vec2>& texcoords_of(std::size_t set) const {
    return set == 0 ? texcoords : more_uv_sets[set - 1].texcoords;
  }
  std::int32_t texcoord(std::size_t set, std::size_t triangle, std::size_t corner) const {
    return set == 0 ? triangles[triangle][corner].texcoord : more_uv_sets[set - 1].corners[triangle][corner];
  }
};

/// \throw InputError for coordinates that are not numbers, or too large or small to compute with (see
/// CoordinateRange). \pre indices are in range
void check_size(const TexturedTriangles& input);

/// \throw InputError naming the triangle for indices out of range or texture coordinates on some corners
/// only, for lists whose lengths do not fit, and as check_size()
void check(const TexturedTriangles& input);

}  // namespace multimesh
