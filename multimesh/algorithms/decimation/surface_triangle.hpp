// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "multimesh/algorithms/decimation/collapse_plan.hpp"
#include "multimesh/algorithms/decimation/ranks.hpp"

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
  /// \throw InputError if it has more than max_sets charts
  TriangleReader(EmbeddedMesh& surface, const Ranks& ranks);

  const MultiMesh& tree() const noexcept { return surface_.tree(); }
  const Mesh& mesh() const noexcept { return mesh_; }
  const Ranks& ranks() const noexcept { return ranks_; }
  std::array<Vec3, 3> positions(Dart d) const;
  const std::vector<Vec3>& positions() const noexcept { return positions_; }
  std::size_t n_sets() const noexcept { return textures_.size(); }
  NodeId node() const noexcept { return surface_.node(); }
  const Coordinates& coordinates() const noexcept { return surface_.positions(); }
  NodeId texture(std::size_t set) const { return textures_[set].node; }
  const std::vector<Vec2>& texcoords(std::size_t set) const { return *textures_[set].texcoords; }
  void read(Dart d, SurfaceTriangle& triangle) const;
  /// Of the box around the vertices, as they were at the start.
  double diagonal() const noexcept { return diagonal_; }

 private:
  struct Texture {
    NodeId node;
    const Mesh* mesh;
    std::vector<FacetCopies> down;  ///< from the surface, step by step
    std::unique_ptr<CoordinateList<Vec2>> list;
    const std::vector<Vec2>* texcoords;
    Dart facet_over(Dart d) const;
  };
  void add_texture(Coordinates& chart);
  void read_curves(Dart d, const std::array<Dart, max_sets>& copies, SurfaceTriangle& triangle) const;

  EmbeddedMesh& surface_;
  const Ranks& ranks_;
  const Mesh& mesh_;
  CoordinateList<Vec3> list_;
  const std::vector<Vec3>& positions_;
  double diagonal_;
  std::vector<Texture> textures_;
};

}  // namespace multimesh::decimation
