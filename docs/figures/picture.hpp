// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>

#include "multimesh/domains/textured_surface.hpp"
#include "svg.hpp"

namespace multimesh::figures {

/// Rotates about the vertical axis, then towards the viewer, in radians; z is the depth.
Vec3 turned(const Vec3& p, double around, double towards);

/// The live triangles of a mesh, as darts.
DartBuffer triangles_of(const Mesh& mesh);
std::array<Index, 4> vertices_of(const Mesh& mesh, Dart d);

/// Charts of the texture: per triangle of the texture, which component.
std::vector<std::size_t> charts(const Mesh& texture);

/// The surface from one side, far triangles first; seams as thick lines. `fill` per triangle of the surface.
void draw_surface(Svg& svg, const TexturedSurface& surface, Vec2 corner, Vec2 size,
                  const std::function<std::string(Index)>& fill, double around, double towards);
/// The atlas, its border as thick lines. `fill` per triangle of the texture.
void draw_texture(Svg& svg, const TexturedSurface& surface, Vec2 corner, Vec2 size,
                  const std::function<std::string(Index)>& fill);

}  // namespace multimesh::figures
