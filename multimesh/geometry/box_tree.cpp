// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/geometry/box_tree.hpp"

#include <algorithm>

namespace multimesh::spatial {

namespace {

constexpr std::ptrdiff_t leaf_size = 4;

}  // namespace

BoxTree::BoxTree(const std::vector<Triangle>& triangles) {
  std::vector<Item> items(triangles.size());
  for (Index f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({t[0][i], t[1][i], t[2][i]});
      items[f].middle[i] = low / 2 + high / 2;
    }
    items[f].facet = f;
  }
  order_.reserve(items.size());
  nodes_.reserve(items.size() / 2 + 1);
  if (!items.empty()) build(triangles, items.data(), items.data() + items.size());
}

void BoxTree::build(const std::vector<Triangle>& triangles, Item* begin, Item* end) {
  const auto here = static_cast<Index>(nodes_.size());
  Node& node = nodes_.emplace_back();
  node.low = node.high = triangles[begin->facet][0];
  Vec3 least = begin->middle, most = least;
  for (const Item* item = begin; item != end; ++item)
    for (std::size_t i = 0; i < 3; ++i) {
      for (const Vec3& p : triangles[item->facet]) {
        node.low[i] = std::min(node.low[i], p[i]);
        node.high[i] = std::max(node.high[i], p[i]);
      }
      least[i] = std::min(least[i], item->middle[i]);
      most[i] = std::max(most[i], item->middle[i]);
    }
  if (end - begin <= leaf_size) {
    node.first = static_cast<Index>(order_.size());
    node.count = static_cast<Index>(end - begin);
    for (const Item* item = begin; item != end; ++item) order_.push_back(item->facet);
    return;
  }
  node.count = 0;
  std::size_t axis = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (most[i] - least[i] > most[axis] - least[axis]) axis = i;
  Item* const middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end, [axis](const Item& a, const Item& b) {
    return a.middle[axis] < b.middle[axis] || (a.middle[axis] == b.middle[axis] && a.facet < b.facet);
  });
  build(triangles, begin, middle);
  nodes_[here].first = static_cast<Index>(nodes_.size());
  build(triangles, middle, end);
}

}  // namespace multimesh::spatial
