// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/polygon_clipper.hpp"

#include <algorithm>
#include <tuple>

namespace multimesh::io {
namespace {

constexpr std::uint32_t nothing = PlaneTree::nothing;

double distance2(const Point2& a, const Point2& b) {
  return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

constexpr auto is_worse = [](const auto& x, const auto& y) {
  return std::tie(x.rank, x.quality, y.corner) < std::tie(y.rank, y.quality, x.corner);
};

}  // namespace

std::span<const PolygonClipper::Triangle> PolygonClipper::clip(std::span<const Point2> points,
                                                               std::span<const std::int32_t> names) {
  points_ = points;
  names_ = names;
  triangles_.clear();
  link(static_cast<std::uint32_t>(points.size()));
  while (triangles_.size() + 3 < points.size()) cut(best());
  const std::uint32_t last = best();
  triangles_.push_back({nodes_[last].before, last, nodes_[last].after});
  return triangles_;
}

void PolygonClipper::link(std::uint32_t count) {
  nodes_.resize(count);
  queue_.clear();
  blocked_.clear();
  tree_.build(points_);
  for (std::uint32_t i = 0; i < count; ++i)
    nodes_[i] = {(i + count - 1) % count, (i + 1) % count, 0, nothing};
  for (std::uint32_t i = 0; i < count; ++i) judge(i);
}

void PolygonClipper::judge(std::uint32_t i) {
  Node& node = nodes_[i];
  ++node.judged;
  const Point2 &a = points_[node.before], &b = points_[i], &c = points_[node.after];
  const double area = area2(a, b, c);
  const double longest = std::max({distance2(a, b), distance2(b, c), distance2(c, a)});
  queue_.push_back({rank_of(i, area), longest > 0 ? area / longest : 0, i, node.judged});
  std::ranges::push_heap(queue_, is_worse);
}

PolygonClipper::Rank PolygonClipper::rank_of(std::uint32_t i, double area) {
  const Node& node = nodes_[i];
  const std::int32_t a = names_[node.before], b = names_[i], c = names_[node.after];
  if (a == b || b == c || c == a) return Rank::pinched;
  if (area < 0) return Rank::inverted;
  if (area == 0) return Rank::flat;
  return is_blocked(i) ? Rank::blocked : Rank::ear;
}

/// Whether another corner lies in the triangle, or on the diagonal that would cut it off. Corners at the
/// places of its own three corners do not count: in a polygon that only touches itself, edges from these lead
/// outwards. The corner that was found is notified: when it is cut off, this one is judged again.
bool PolygonClipper::is_blocked(std::uint32_t i) {
  const std::uint32_t by =
      tree_.find_in_triangle(points_[nodes_[i].before], points_[i], points_[nodes_[i].after]);
  if (by == nothing) return false;
  blocked_.push_back({i, nodes_[i].judged, nodes_[by].blocked});
  nodes_[by].blocked = static_cast<std::uint32_t>(blocked_.size() - 1);
  return true;
}

std::uint32_t PolygonClipper::best() {
  while (true) {
    std::ranges::pop_heap(queue_, is_worse);
    const Candidate candidate = queue_.back();
    queue_.pop_back();
    if (candidate.judged == nodes_[candidate.corner].judged) return candidate.corner;
  }
}

void PolygonClipper::cut(std::uint32_t i) {
  const std::uint32_t before = nodes_[i].before, after = nodes_[i].after;
  triangles_.push_back({before, i, after});
  nodes_[before].after = after;
  nodes_[after].before = before;
  nodes_[i].judged = nothing;  // its entries in the queue become void
  tree_.remove(i);
  judge(before);
  judge(after);
  for (std::uint32_t b = nodes_[i].blocked; b != nothing;) {
    const Blocked blocked = blocked_[b];
    if (blocked.judged == nodes_[blocked.corner].judged) judge(blocked.corner);
    b = blocked.next;
  }
}

}  // namespace multimesh::io
