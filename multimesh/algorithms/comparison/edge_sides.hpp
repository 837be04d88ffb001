// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "multimesh/algorithms/comparison/corners.hpp"

namespace multimesh::comparison {

/// A triangle at one of its edges; the edge's ends in the order of their positions' numbers.
struct EdgeSide {
  Index triangle;
  TexturedTriangles::Corner low, high;
  bool forward;  ///< the triangle runs from low to high
};

/// The sides of all edges of a surface as given; nothing is cut.
class EdgeSides {
 public:
  explicit EdgeSides(const TexturedTriangles& surface);

  /// Calls visit(sides) for each edge: one side at the boundary, two inside, more where it is not manifold.
  template <class Visit>
  void for_each_edge(Visit visit) const {
    for (std::size_t i = 0, j; i < sides_.size(); i = j) {
      for (j = i; j < sides_.size() && same_edge(sides_[i], sides_[j]);) ++j;
      visit(std::span<const EdgeSide>(sides_).subspan(i, j - i));
    }
  }

  /// Whether both are textured by the same points of the texture, so that no seam runs between them.
  bool same_texture(const EdgeSide& a, const EdgeSide& b) const;

 private:
  static bool same_edge(const EdgeSide& a, const EdgeSide& b) {
    return a.low.position == b.low.position && a.high.position == b.high.position;
  }
  const TexturedTriangles& surface_;
  std::vector<EdgeSide> sides_;
};

/// The points of the texture on both sides of an interior edge of the surface, at both ends.
struct SeamEdge {
  std::array<Vec3, 2> position;
  std::array<Index, 2> triangle;  ///< on the left and on the right
  std::array<Vec2, 2> left, right;
};

/// Edges whose two sides are textured and differ.
std::vector<SeamEdge> seam_edges(const TexturedTriangles& surface, const EdgeSides& sides);

}  // namespace multimesh::comparison
