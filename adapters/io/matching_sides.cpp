// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/matching_sides.hpp"

#include <algorithm>

namespace multimesh::io {
namespace {

using Point = std::array<double, 3>;

/// The other two coordinates of the points with this one, sorted.
std::vector<std::array<double, 2>> side(std::span<const Point> points, std::size_t axis, double at) {
  std::vector<std::array<double, 2>> found;
  for (const Point& p : points)
    if (p[axis] == at) found.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3]});
  std::ranges::sort(found);
  return found;
}

}  // namespace

std::vector<std::string> axes_with_matching_sides(std::span<const Point> points) {
  std::vector<std::string> axes;
  for (std::size_t axis = 0; axis < 3 && !points.empty(); ++axis) {
    const auto [low, high] = std::ranges::minmax(points, {}, [&](const Point& p) { return p[axis]; });
    if (low[axis] == high[axis]) continue;
    const auto first = side(points, axis, low[axis]);
    if (first.size() > 4 && first == side(points, axis, high[axis]))
      axes.emplace_back(1, static_cast<char>('x' + axis));
  }
  return axes;
}

}  // namespace multimesh::io
