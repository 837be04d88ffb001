// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "multimesh/algorithms/decimation/collapse_plan.hpp"
#include "multimesh/algorithms/decimation/strata.hpp"

namespace multimesh::decimation {

/// A triangle of the surface with all that belongs to its corners, in the order of a dart.
struct SurfaceTriangle {
  struct Textured {
    Index facet =
        no_index;  ///< of the texture; no_index: the triangle has no texture coordinates in this set
    std::array<Index, 3> vertices;
    std::array<Vec2, 3> texcoords;
    std::array<bool, 3> open;  ///< whether edge i, from corner i to i+1, is in the boundary of the texture
  };

  Index facet = no_index;
  std::array<Index, 3> vertices;
  std::array<Vec3, 3> positions;
  bool has_curves = false;              ///< whether any edge is a curve, or open in a texture; if not, then
                                        ///< `curve_weights` and `open` are not set
  std::array<double, 3> curve_weights;  ///< of edge i; 0: no curve
  std::array<Textured, max_sets> sets;
};

/// Sets all curves of a triangle to none.
inline void clear_curves(SurfaceTriangle& t) {
  t.has_curves = false;
  t.curve_weights = {};
  for (SurfaceTriangle::Textured& set : t.sets) set.open = {};
}

/// Reads triangles of a surface.
class TriangleReader {
 public:
  TriangleReader(const TexturedSurface& surface, const Strata& strata);

  std::size_t n_sets() const noexcept { return textures_.size(); }
  void read(Dart d, SurfaceTriangle& triangle) const;

 private:
  void read_curves(Dart d, const std::array<Dart, max_sets>& copies, SurfaceTriangle& triangle) const;

  const Strata& strata_;
  const Mesh& root_;
  const std::vector<Vec3>& positions_;
  struct Texture {
    FacetCopies facet_over;
    const Mesh* mesh;
    const std::vector<Vec2>* texcoords;
  };
  std::vector<Texture> textures_;
};

}  // namespace multimesh::decimation
