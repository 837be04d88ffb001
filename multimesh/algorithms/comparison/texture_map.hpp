// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/comparison/corners.hpp"
#include "multimesh/spatial/triangle_tree.hpp"

namespace multimesh::comparison {

/// The map X from the texture to space: the place of the surface whose content is at a point of its texture.
/// Keeps a reference to the surface. Queries may run on many threads.
class TextureMap {
 public:
  /// Where to search first: in the texture, which is faster unless many triangles share one place of it; or
  /// in space. The result is the same.
  enum class Search { automatic, texture, space };
  /// \pre some triangle is textured
  explicit TextureMap(const TexturedTriangles& surface, Search search = Search::automatic);

  struct Place {
    Vec3 position;
    Index triangle = no_index;  ///< of the surface
    double uv_distance = 0;     ///< from the query point to the texture, roughly if below `touching`
  };
  /// X(uv). Outside the texture its nearest point counts. Where charts overlap, or lie closer than
  /// `touching`, the place nearest to `near` counts. `buffer` is working memory.
  Place operator()(const Vec2& uv, const Vec3& near, std::vector<spatial::Nearby>& buffer) const;

  /// X(uv) using only the triangles with `part[triangle] == which`: the one nearest in the texture. None if
  /// there are no such triangles. `part`: per triangle of the surface.
  std::optional<Place> within(const Vec2& uv, const std::vector<Index>& part, Index which) const;

  double diagonal() const { return diagonal_; }         ///< of the bounding box in the UV plane
  double touching() const { return 2e-5 * diagonal_; }  ///< in UV: a fraction of a texel
  double rounding() const { return 1e-6 * diagonal_; }  ///< in UV: the resolution of files with six digits

 private:
  bool is_stacked() const;
  Place place(const spatial::Nearby& found, double uv_distance) const;
  Place search_texture(const Vec3& uv, const Vec3& near, std::vector<spatial::Nearby>& buffer) const;

  const TexturedTriangles& surface_;
  std::vector<Index> textured_;  // the triangles in the trees
  double diagonal_ = 0;
  spatial::TriangleTree in_texture_;
  std::optional<spatial::TriangleTree> in_space_;  // if space is searched first
};

}  // namespace multimesh::comparison
