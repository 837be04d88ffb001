// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "multimesh/domains/textured_surface.hpp"
#include "multimesh/geometry/closest_point.hpp"

namespace multimesh::comparison {

// The corners of a triangle of a surface, as points for the closest-point queries and back.

using Corners = std::array<TexturedTriangles::Corner, 3>;

inline bool is_textured(const Corners& t) {
  return std::all_of(t.begin(), t.end(), [](const auto& c) { return c.texcoord >= 0; });
}

inline const Vec3& position(const TexturedTriangles& s, const TexturedTriangles::Corner& c) {
  return s.positions[static_cast<std::size_t>(c.position)];
}
inline const Vec2& texcoord(const TexturedTriangles& s, const TexturedTriangles::Corner& c) {
  return s.texcoords[static_cast<std::size_t>(c.texcoord)];
}

inline spatial::Triangle in_space(const TexturedTriangles& s, const Corners& t) {
  return {position(s, t[0]), position(s, t[1]), position(s, t[2])};
}
/// \pre is_textured(t)
inline spatial::Triangle in_texture(const TexturedTriangles& s, const Corners& t) {
  return {in_space(texcoord(s, t[0])), in_space(texcoord(s, t[1])), in_space(texcoord(s, t[2]))};
}

/// The signed area of a triangle of the UV plane.
inline double signed_area(const spatial::Triangle& t) {
  return ((t[1][0] - t[0][0]) * (t[2][1] - t[0][1]) - (t[2][0] - t[0][0]) * (t[1][1] - t[0][1])) / 2;
}

}  // namespace multimesh::comparison
