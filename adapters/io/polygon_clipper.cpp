// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/polygon_clipper.hpp"

#include <algorithm>
#include <tuple>

namespace multimesh::io {
namespace {

/// Twice the signed area.
double area2(const Point2& a, const Point2& b, const Point2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

double distance2(const Point2& a, const Point2& b) {
  return (b[0] - a[0]) * (b[0] - a[0]) + (b[1] - a[1]) * (b[1] - a[1]);
}

}  // namespace

std::span<const PolygonClipper::Triangle> PolygonClipper::clip(std::span<const Point2> points,
                                                               std::span<const std::int32_t> names) {
  points_ = points;
  names_ = names;
  triangles_.clear();
  link(static_cast<std::uint32_t>(points.size()));
  while (left_ > 3) cut(best());
  triangles_.push_back({nodes_[first_].before, first_, nodes_[first_].after});
  return triangles_;
}

void PolygonClipper::link(std::uint32_t count) {
  nodes_.resize(count);
  first_ = 0;
  left_ = count;
  for (std::uint32_t i = 0; i < count; ++i)
    nodes_[i] = {(i + count - 1) % count, (i + 1) % count, Rank::blocked, 0};
  for (std::uint32_t i = 0; i < count; ++i) judge(i);
}

void PolygonClipper::judge(std::uint32_t i) {
  Node& node = nodes_[i];
  const Point2 &a = points_[node.before], &b = points_[i], &c = points_[node.after];
  const double area = area2(a, b, c);
  const double longest = std::max({distance2(a, b), distance2(b, c), distance2(c, a)});
  node.quality = longest > 0 ? area / longest : 0;
  node.rank = rank_of(i, area);
}

PolygonClipper::Rank PolygonClipper::rank_of(std::uint32_t i, double area) const {
  const Node& node = nodes_[i];
  const std::int32_t a = names_[node.before], b = names_[i], c = names_[node.after];
  if (a == b || b == c || c == a) return Rank::pinched;
  if (area < 0) return Rank::inverted;
  if (is_blocked(i)) return Rank::blocked;
  return area > 0 ? Rank::ear : Rank::flat;
}

/// Another corner lies in the triangle, or on the diagonal that would cut it off. Corners at the places of
/// its own three corners do not count: in a polygon that only touches itself, what leaves them leads
/// outwards.
bool PolygonClipper::is_blocked(std::uint32_t i) const {
  const std::uint32_t before = nodes_[i].before, after = nodes_[i].after;
  const Point2 &a = points_[before], &b = points_[i], &c = points_[after];
  for (std::uint32_t j = nodes_[after].after; j != before; j = nodes_[j].after) {
    const Point2& p = points_[j];
    if (p == a || p == b || p == c) continue;
    if (area2(a, b, p) > 0 && area2(b, c, p) > 0 && area2(c, a, p) >= 0) return true;
  }
  return false;
}

/// The best ear; corners that were blocked are judged again only when no ear is left.
std::uint32_t PolygonClipper::best() {
  const auto worse = [&](std::uint32_t i, std::uint32_t j) {
    return std::tie(nodes_[i].rank, nodes_[i].quality) < std::tie(nodes_[j].rank, nodes_[j].quality);
  };
  const auto find = [&](bool again) {
    std::uint32_t found = first_, i = first_;
    for (std::uint32_t n = 0; n < left_; ++n, i = nodes_[i].after) {
      if (again) judge(i);
      if (worse(found, i)) found = i;
    }
    return found;
  };
  const std::uint32_t found = find(false);
  return nodes_[found].rank == Rank::ear ? found : find(true);
}

void PolygonClipper::cut(std::uint32_t i) {
  const std::uint32_t before = nodes_[i].before, after = nodes_[i].after;
  triangles_.push_back({before, i, after});
  nodes_[before].after = after;
  nodes_[after].before = before;
  first_ = before;
  --left_;
  judge(before);
  judge(after);
}

}  // namespace multimesh::io
