// SPDX-License-Identifier: BSD-3-Clause
// Private to the files textured_surface*.cpp.
#pragma once

#include "multimesh/cut.hpp"
#include "multimesh/domains/textured_surface.hpp"

namespace multimesh {

/// The lists belong to their meshes: they grow with them, and are compacted with them.
struct TexturedSurface::Data {
  std::unique_ptr<MultiMesh> tree;
  std::vector<NodeId> textures;               // by set
  std::vector<std::vector<Vec2>*> texcoords;  // by set, per vertex of its texture
  std::optional<NodeId> curves;
  std::vector<CurveKinds>* curve_kinds = nullptr;  // per edge of the curves
  std::vector<Vec3>* positions = nullptr;          // per vertex of the surface
  std::vector<Vec3>* colors = nullptr;             // per vertex of the surface, or null
  std::vector<Index>* source_position = nullptr;   // per vertex of the surface: the input's index
  std::vector<char>* is_copy = nullptr;            // per vertex of the surface
  std::vector<char>* hard = nullptr;               // per edge of the surface, or null
  std::vector<char>* triangle_shading = nullptr;   // per triangle of the surface: ShadingBits; or null
  std::vector<Index>* source_triangle = nullptr;   // per triangle of the surface
  std::vector<char>* reversed = nullptr;           // per triangle of the surface
  CutReport report;
  std::vector<Vec2> no_texcoords;
  std::vector<Vec3> no_colors;

  /// The list of new values, which the mesh owns.
  template <class T>
  std::vector<T>* add_values(NodeId n, int k, const char* name) {
    return &tree->mesh(n).add_values<T>(k, name);
  }
};

/// Makes the root, and returns how the input was cut.
Cut add_surface(const TexturedTriangles& input, TexturedSurface::Data& out);
/// Adds the texture of a set. \pre the sets before it have been added
void add_texture(const TexturedTriangles& input, const Cut& surface, std::size_t set,
                 TexturedSurface::Data& out);
/// Adds the curves of all kinds. \pre all textures have been added
void add_curves(const TexturedTriangles& input, const TexturedSurfaceOptions& options,
                TexturedSurface::Data& out);

}  // namespace multimesh
