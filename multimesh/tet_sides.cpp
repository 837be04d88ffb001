// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/tet_sides.hpp"

#include <algorithm>

namespace multimesh {

void for_each_face(const FacetList& tets, const std::function<void(std::span<const Index>)>& visit) {
  const auto n = static_cast<Index>(tets.corners.size());
  const auto vertex_of = [&](Index c) { return tets.corners[c]; };
  const auto least = [&](Index side) { return vertex_of(side_corners(side, vertex_of)[0]); };
  std::vector<Index> begin(std::size_t{tets.vertices} + 1, 0);
  for (Index s = 0; s < n; ++s) ++begin[least(s) + 1];
  for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
  std::vector<Index> sides(n), end(begin.begin(), begin.end() - 1);
  for (Index s = 0; s < n; ++s) sides[end[least(s)]++] = s;

  std::vector<std::array<Index, 3>> bucket;  // the two other vertices, the side
  std::vector<Index> same;
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    bucket.clear();
    for (Index i = begin[v]; i < begin[v + 1]; ++i) {
      const auto c = side_corners(sides[i], vertex_of);
      bucket.push_back({vertex_of(c[1]), vertex_of(c[2]), sides[i]});
    }
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t i = 0; i < bucket.size();) {
      same.clear();
      const std::size_t first = i;
      for (; i < bucket.size() && bucket[i][0] == bucket[first][0] && bucket[i][1] == bucket[first][1]; ++i)
        same.push_back(bucket[i][2]);
      visit(same);
    }
  }
}

}  // namespace multimesh
