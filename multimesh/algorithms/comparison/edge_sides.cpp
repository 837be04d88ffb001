// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/comparison/edge_sides.hpp"

#include <tuple>

namespace multimesh::comparison {

EdgeSides::EdgeSides(const TexturedTriangles& surface) : surface_(surface) {
  sides_.reserve(3 * surface.triangles.size());
  for (Index t = 0; t < surface.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto a = surface.triangles[t][i], b = surface.triangles[t][(i + 1) % 3];
      const bool forward = a.position < b.position;
      sides_.push_back({t, forward ? a : b, forward ? b : a, forward});
    }
  std::sort(sides_.begin(), sides_.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low.position, a.high.position, a.triangle) <
           std::tie(b.low.position, b.high.position, b.triangle);
  });
}

bool EdgeSides::same_texture(const EdgeSide& a, const EdgeSide& b) const {
  const auto same = [&](const TexturedTriangles::Corner& x, const TexturedTriangles::Corner& y) {
    return x.texcoord >= 0 && y.texcoord >= 0 && texcoord(surface_, x) == texcoord(surface_, y);
  };
  return same(a.low, b.low) && same(a.high, b.high);
}

std::vector<SeamEdge> seam_edges(const TexturedTriangles& surface, const EdgeSides& sides) {
  std::vector<SeamEdge> seams;
  const auto ends = [&](const EdgeSide& s) {
    return std::array<Vec2, 2>{texcoord(surface, s.low), texcoord(surface, s.high)};
  };
  sides.for_each_edge([&](std::span<const EdgeSide> at) {
    if (at.size() != 2 || sides.same_texture(at[0], at[1])) return;
    if (!is_textured(surface.triangles[at[0].triangle]) || !is_textured(surface.triangles[at[1].triangle]))
      return;
    seams.push_back({{position(surface, at[0].low), position(surface, at[0].high)},
                     {at[0].triangle, at[1].triangle},
                     ends(at[0]),
                     ends(at[1])});
  });
  return seams;
}

}  // namespace multimesh::comparison
