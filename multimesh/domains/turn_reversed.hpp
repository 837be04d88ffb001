// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/domains/textured_surface.hpp"

namespace multimesh {

/// Turns round the triangles that `surface` runs through the other way, so that neighbours agree wherever the
/// surface is orientable; texture coordinates and shading with them. A surface that is made anew of `input`
/// has no borders between triangles that were turned and others. \pre `surface` was made of `input`, and not
/// changed since. \return how many were turned
std::size_t turn_reversed(const TexturedSurface& surface, TexturedTriangles& input);

}  // namespace multimesh
