// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/openmesh/corner_classes.hpp"

#include <algorithm>
#include <bit>

namespace multimesh::openmesh {

namespace {

/// The corners of each vertex side by side, in their order: those of v are corners[begin[v]..begin[v + 1]).
struct CornersByVertex {
  std::vector<Index> begin, corners;

  CornersByVertex(std::span<const Index> vertex, Index vertices)
      : begin(static_cast<std::size_t>(vertices) + 1, 0), corners(vertex.size()) {
    for (const Index v : vertex) ++begin[v + 1];
    for (Index v = 0; v < vertices; ++v) begin[v + 1] += begin[v];
    for (Index c = 0; c < vertex.size(); ++c) corners[begin[vertex[c]]++] = c;
    for (Index v = vertices; v > 0; --v) begin[v] = begin[v - 1];
    begin[0] = 0;
  }
};

struct Valued {
  std::uint64_t u, v;
  Index corner;
  friend auto operator<=>(const Valued&, const Valued&) = default;
};

/// Bits that are equal for equal numbers, in some order: a nan has one, too.
std::uint64_t bits(double x) {
  return std::bit_cast<std::uint64_t>(x + 0.0);
}

}  // namespace

std::vector<Index> first_equal_corners(std::span<const Index> vertex, Index vertices,
                                       std::span<const Index> texcoord, std::span<const Vec2> values) {
  const CornersByVertex by_vertex(vertex, vertices);
  std::vector<Index> first(vertex.size());
  std::vector<Valued> here;
  for (Index v = 0; v < vertices; ++v) {
    const std::span at(by_vertex.corners.data() + by_vertex.begin[v],
                       by_vertex.begin[v + 1] - by_vertex.begin[v]);
    const auto as_the_first = [&](Index c) { return texcoord[c] == texcoord[at.front()]; };
    if (std::all_of(at.begin(), at.end(), as_the_first)) {
      for (const Index c : at) first[c] = at.front();
      continue;
    }
    here.clear();
    for (const Index c : at) here.push_back({bits(values[texcoord[c]][0]), bits(values[texcoord[c]][1]), c});
    std::sort(here.begin(), here.end());
    for (std::size_t i = 0, start = 0; i < here.size(); ++i) {
      if (here[i].u != here[start].u || here[i].v != here[start].v) start = i;
      first[here[i].corner] = here[start].corner;
    }
  }
  return first;
}

}  // namespace multimesh::openmesh
