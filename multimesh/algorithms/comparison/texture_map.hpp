// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/comparison/corners.hpp"
#include "multimesh/spatial/triangle_tree.hpp"

namespace multimesh::comparison {

/// The map X from the texture to space: what place of the surface is painted at a point of its texture.
/// Keeps a reference to the surface. Queries may be asked from many threads.
class TextureMap {
 public:
  /// Where to look for places first: in the texture, the faster way if not many triangles share one place of
  /// it; or in space. It does not change what is found.
  enum class Search { automatic, texture, space };
  /// \pre some triangle is textured
  explicit TextureMap(const TexturedTriangles& surface, Search search = Search::automatic);

  struct Place {
    Vec3 position;
    Index triangle = no_index;  ///< of the surface
    double uv_distance = 0;     ///< from the point asked for to the texture, roughly if below `touching`
  };
  /// X(uv). Outside of the texture its nearest point counts. Where charts overlap, or lie closer than
  /// `touching`, that one of the places that is nearest to `near`. `buffer` is working memory.
  Place operator()(const Vec2& uv, const Vec3& near, std::vector<spatial::Nearby>& buffer) const;

  /// X(uv) by the triangles with `part[triangle] == which` alone: by that one of them that is nearest in the
  /// texture. None if there are none. `part`: per triangle of the surface.
  std::optional<Place> within(const Vec2& uv, const std::vector<Index>& part, Index which) const;

  double diagonal() const { return diagonal_; }         ///< of the bounding box in the UV plane
  double touching() const { return 2e-5 * diagonal_; }  ///< in UV: a fraction of a texel
  double rounding() const { return 1e-6 * diagonal_; }  ///< in UV: what files of six digits leave open

 private:
  bool is_stacked() const;
  Place place(const spatial::Nearby& found, double uv_distance) const;
  Place search_texture(const Vec3& uv, const Vec3& near, std::vector<spatial::Nearby>& buffer) const;

  const TexturedTriangles& surface_;
  std::vector<Index> textured_;  // the triangles in the trees
  double diagonal_ = 0;
  spatial::TriangleTree in_texture_;
  std::optional<spatial::TriangleTree> in_space_;  // if it is asked first
};

}  // namespace multimesh::comparison
