// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "multimesh/domains/textured_surface.hpp"
#include "test/support/shapes.hpp"

namespace multimesh::test {

/// Texture coordinates as an affine function of position: (u, v) = rows[0..1] . (x, y, z, 1).
struct AffineMap {
  std::array<std::array<double, 4>, 2> rows;
  Vec2 operator()(const Vec3& p) const;
};

/// A surface made by code. If `maps` is not empty, the texture coordinates of a triangle of chart c are
/// maps[c] of its positions. Any correct decimation of a planar part must preserve this.
struct MadeSurface {
  std::string name;
  TexturedTriangles input;
  std::vector<std::size_t> chart;  ///< per triangle; no_texture: none
  std::vector<AffineMap> maps;
};

/// Used by GoogleTest, which would otherwise print the bytes of a parameter.
inline void PrintTo(const MadeSurface& s, std::ostream* out) {
  *out << s.name;
}

inline constexpr std::size_t no_texture = ~std::size_t{0};

/// Texture coordinates by triangle and position; a chart per triangle.
using Unwrap = std::function<Vec2(std::size_t triangle, const Vec3& position)>;

TexturedTriangles bare(const Shape& shape);
/// One texture coordinate per corner: equal values must be found to be equal.
void add_texture(TexturedTriangles& surface, const Unwrap& unwrap);
/// Charts by the centroid of each triangle; maps[chart] unwraps it, no_texture leaves it bare.
MadeSurface with_charts(std::string name, const Shape& shape,
                        const std::function<std::size_t(const Vec3& centroid)>& chart,
                        std::vector<AffineMap> maps);

MadeSurface one_chart();        ///< a planar grid
MadeSurface two_charts();       ///< a planar grid, one seam across it
MadeSurface mirrored_chart();   ///< the same, one of the charts mirrored
MadeSurface half_without();     ///< the same, one half without texture
MadeSurface zero_area_chart();  ///< the same, one of the charts collapsed to a point
MadeSurface touching_charts();  ///< four quadrants; two of them touch in a point of the texture
MadeSurface slit();             ///< a planar grid, the seam ends in its interior
MadeSurface polar_annulus();    ///< angle and radius, one seam between the two boundaries
MadeSurface tiled_torus();      ///< the square tile; two closed seams that cross
MadeSurface octahedron();       ///< eight flat faces, a chart each, every other one mirrored
MadeSurface sphere_with_charts();
MadeSurface book();           ///< three planar pages on a spine: edges with three faces
MadeSurface pinched();        ///< two planar sheets that touch in a vertex
MadeSurface self_touching();  ///< a sheet with two vertices of its boundary joined in one point
MadeSurface half_reversed();  ///< two_charts, with one half of the triangles reversed

std::vector<MadeSurface> made_surfaces();

}  // namespace multimesh::test
