// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/used_points.hpp"

#include <algorithm>
#include <limits>

namespace multimesh::io {

std::vector<std::uint32_t> remove_unused_points(SimplexSoup& soup) {
  constexpr std::uint32_t removed = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> renumbered(soup.points.size(), removed);
  for (const auto& block : soup.simplices)
    for (const std::uint32_t v : block.corners) renumbered[v] = 0;
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < renumbered.size(); ++i) {
    if (renumbered[i] == removed) continue;
    soup.points[kept] = soup.points[i];
    if (!soup.point_tags.empty()) soup.point_tags[kept] = soup.point_tags[i];
    renumbered[i] = kept++;
  }
  soup.points.resize(kept);
  if (!soup.point_tags.empty()) soup.point_tags.resize(kept);
  for (auto& block : soup.simplices)
    for (std::uint32_t& v : block.corners) v = renumbered[v];
  for (auto& link : soup.periodic) {
    std::erase_if(link.points, [&](const auto& pair) {
      return renumbered[pair[0]] == removed || renumbered[pair[1]] == removed;
    });
    for (auto& pair : link.points) pair = {renumbered[pair[0]], renumbered[pair[1]]};
  }
  soup.notes.unused_points = 0;
  return renumbered;
}

}  // namespace multimesh::io
