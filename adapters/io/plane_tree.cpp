// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/plane_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace multimesh::io {
namespace {

constexpr std::uint32_t leaf_size = 16;

}  // namespace

void PlaneTree::build(std::span<const Point2> points) {
  points_ = points;
  const auto count = static_cast<std::uint32_t>(points.size());
  order_.resize(count);
  std::iota(order_.begin(), order_.end(), 0U);
  leaf_.assign(count, nothing);
  nodes_.clear();
  nodes_.push_back({box_of(0, count), 0, count, nothing, nothing, count});
  for (std::uint32_t n = 0; n < nodes_.size(); ++n) split(n);
}

PlaneTree::Box PlaneTree::box_of(std::uint32_t begin, std::uint32_t end) const {
  Box box{points_[order_[begin]], points_[order_[begin]]};
  for (std::uint32_t i = begin + 1; i < end; ++i)
    for (std::size_t k = 0; k < 2; ++k) {
      box.least[k] = std::min(box.least[k], points_[order_[i]][k]);
      box.most[k] = std::max(box.most[k], points_[order_[i]][k]);
    }
  return box;
}

void PlaneTree::split(std::uint32_t node) {
  const auto [box, begin, end, left, parent, count] = nodes_[node];
  if (end - begin <= leaf_size) {
    for (std::uint32_t i = begin; i < end; ++i) leaf_[order_[i]] = node;
    return;
  }
  const std::size_t axis = box.most[0] - box.least[0] >= box.most[1] - box.least[1] ? 0 : 1;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t i, std::uint32_t j) { return points_[i][axis] < points_[j][axis]; });
  nodes_[node].left = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({box_of(begin, middle), begin, middle, nothing, node, middle - begin});
  nodes_.push_back({box_of(middle, end), middle, end, nothing, node, end - middle});
}

void PlaneTree::remove(std::uint32_t point) {
  for (std::uint32_t n = leaf_[point]; n != nothing; n = nodes_[n].parent) --nodes_[n].count;
  leaf_[point] = nothing;
}

std::uint32_t PlaneTree::find_in_triangle(const Point2& a, const Point2& b, const Point2& c) const {
  Box bounds{a, a};
  for (const Point2& p : {b, c})
    for (std::size_t k = 0; k < 2; ++k) {
      bounds.least[k] = std::min(bounds.least[k], p[k]);
      bounds.most[k] = std::max(bounds.most[k], p[k]);
    }
  const auto is_inside = [&](const Point2& p) {
    return area2(a, b, p) > 0 && area2(b, c, p) > 0 && area2(c, a, p) >= 0 && p != a && p != b && p != c;
  };
  // The whole box on the outer side of the edge from p to q, by more than rounding.
  const auto is_beyond = [](const Box& box, const Point2& p, const Point2& q) {
    const double x = q[0] - p[0], y = q[1] - p[1];
    const double up = (x > 0 ? box.most[1] : box.least[1]) - p[1];
    const double right = (y > 0 ? box.least[0] : box.most[0]) - p[0];
    return x * up - y * right < -1e-14 * (std::abs(x * up) + std::abs(y * right));
  };
  const auto meets = [&](const Box& box) {
    for (std::size_t k = 0; k < 2; ++k)
      if (box.least[k] > bounds.most[k] || box.most[k] < bounds.least[k]) return false;
    return !is_beyond(box, a, b) && !is_beyond(box, b, c) && !is_beyond(box, c, a);
  };
  stack_.assign(1, 0);
  while (!stack_.empty()) {
    const Node& node = nodes_[stack_.back()];
    stack_.pop_back();
    if (node.count == 0 || !meets(node.box)) continue;
    if (node.left != nothing) {
      stack_.push_back(node.left);
      stack_.push_back(node.left + 1);
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (leaf_[order_[i]] != nothing && is_inside(points_[order_[i]])) return order_[i];
  }
  return nothing;
}

}  // namespace multimesh::io
