// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/turn_reversed.hpp"

#include <utility>

#include "multimesh/domains/shading.hpp"

namespace multimesh {

namespace {

/// Edge i leads from corner i to the next one: exchanging corners 1 and 2 exchanges edges 0 and 2.
std::uint8_t turned_shading(unsigned bits) {
  const unsigned first = bits & 1U, last = bits >> 2U & 1U;
  return static_cast<std::uint8_t>(((bits & ~5U) | first << 2U | last) ^ normals_behind);
}

void turn(TexturedTriangles& input, Index t) {
  std::swap(input.triangles[t][1], input.triangles[t][2]);
  for (TexturedTriangles::UvSet& set : input.more_uv_sets) std::swap(set.corners[t][1], set.corners[t][2]);
  if (!input.shading.empty()) input.shading[t] = turned_shading(input.shading[t]);
}

}  // namespace

std::size_t turn_reversed(const TexturedSurface& surface, TexturedTriangles& input) {
  if (surface.cut_report().reversed_triangles == 0) return 0;
  std::size_t turned = 0;
  for (Index t = 0; t < input.triangles.size(); ++t) {
    if (!surface.is_reversed(t)) continue;
    turn(input, t);
    ++turned;
  }
  return turned;
}

}  // namespace multimesh
