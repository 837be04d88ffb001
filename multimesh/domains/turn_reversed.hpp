// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/textured_surface.hpp"

namespace multimesh {

/// Reverses the triangles whose orientation `surface` has reversed, with their texture coordinates and
/// shading, so that neighbours agree wherever the surface is orientable. A surface that is made anew from
/// `input` has no borders between reversed triangles and others. \pre `surface` was made from `input`, and
/// not changed since. \return how many were reversed
std::size_t turn_reversed(const TexturedSurface& surface, TexturedTriangles& input);

}  // namespace multimesh
