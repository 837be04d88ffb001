// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/io/weld.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "multimesh/hash.hpp"

namespace multimesh::io {
namespace {

using Point = std::array<double, 3>;

constexpr std::uint32_t nothing = ~std::uint32_t{0};

bool is_finite(const Point& p) {
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

double distance2(const Point& p, const Point& q) {
  const double x = p[0] - q[0], y = p[1] - q[1], z = p[2] - q[2];
  return x * x + y * y + z * z;
}

/// Points in a hash table, by cells: a cell is a point for tolerance 0, otherwise a cube of that size.
class PointTable {
 public:
  PointTable(std::span<const Point> points, double tolerance)
      : points_(points),
        tolerance_(tolerance),
        heads_(std::bit_ceil(points.size() + 1), nothing),
        next_(points.size(), nothing) {}

  /// The nearest point of the table within the tolerance; the earliest of several.
  std::uint32_t find(std::uint32_t i) const {
    const Point cell = cell_of(points_[i]);
    if (tolerance_ == 0) return find_equal(points_[i], slot(cell));
    Found found{tolerance_ * tolerance_, nothing};
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          nearest(points_[i], slot({cell[0] + x, cell[1] + y, cell[2] + z}), found);
    return found.point;
  }

  void insert(std::uint32_t i) {
    const std::size_t at = slot(cell_of(points_[i]));
    next_[i] = heads_[at];
    heads_[at] = i;
  }

 private:
  struct Found {
    double distance2;
    std::uint32_t point;
  };

  Point cell_of(const Point& p) const {
    if (tolerance_ == 0) return p;
    return {std::floor(p[0] / tolerance_), std::floor(p[1] / tolerance_), std::floor(p[2] / tolerance_)};
  }

  std::size_t slot(const Point& cell) const {
    std::array<std::uint64_t, 3> words{};
    // Adding 0 makes -0 and 0 one.
    for (std::size_t k = 0; k < 3; ++k) words[k] = std::bit_cast<std::uint64_t>(cell[k] + 0.0);
    return ArrayHash()(words) & (heads_.size() - 1);
  }

  std::uint32_t find_equal(const Point& p, std::size_t at) const {
    std::uint32_t i = heads_[at];
    while (i != nothing && points_[i] != p) i = next_[i];
    return i;
  }

  // Points of other cells in the slot are harmless: the distance decides.
  void nearest(const Point& p, std::size_t at, Found& found) const {
    for (std::uint32_t i = heads_[at]; i != nothing; i = next_[i]) {
      const double d = distance2(p, points_[i]);
      if (d < found.distance2 || (d == found.distance2 && i < found.point)) found = {d, i};
    }
  }

  std::span<const Point> points_;
  double tolerance_;
  std::vector<std::uint32_t> heads_, next_;
};

}  // namespace

std::vector<std::uint32_t> coincident_points(std::span<const Point> points, double tolerance) {
  PointTable table(points, tolerance);
  std::vector<std::uint32_t> joins(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    joins[i] = i;
    if (!is_finite(points[i])) continue;
    if (const std::uint32_t found = table.find(i); found != nothing)
      joins[i] = found;
    else
      table.insert(i);
  }
  return joins;
}

}  // namespace multimesh::io
