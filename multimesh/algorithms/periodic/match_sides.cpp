// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/periodic/match_sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "multimesh/error.hpp"
#include "multimesh/hash.hpp"

namespace multimesh {

namespace {

using Point = Eigen::Vector3d;

std::string vertex_text(Index v, const Point& p) {
  return "vertex " + std::to_string(v) + " at " + text_of(p);
}

/// Points in cells of twice the search radius: a ball around a point reaches into eight cells at most.
class PointGrid {
 public:
  PointGrid(std::span<const Point> points, std::span<const Index> used, double radius)
      : points_(points), radius_(radius), next_(points.size(), no_index) {
    cells_.reserve(used.size());
    for (const Index v : used) {
      Index& first = cells_.try_emplace(cell(points[v]), no_index).first->second;
      next_[v] = first;
      first = v;
    }
  }

  /// All points within the radius of p.
  void within(const Point& p, std::vector<Index>& out) const {
    out.clear();
    const Key low = cell(p.array() - radius_), high = cell(p.array() + radius_);
    for (std::uint64_t x = low[0]; x != high[0] + 1; ++x)
      for (std::uint64_t y = low[1]; y != high[1] + 1; ++y)
        for (std::uint64_t z = low[2]; z != high[2] + 1; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (Index v = found->second; v != no_index; v = next_[v])
            if ((points_[v] - p).norm() <= radius_) out.push_back(v);
        }
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  Key cell(const Point& p) const {
    const auto along = [&](int i) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[i] / (2 * radius_))));
    };
    return {along(0), along(1), along(2)};
  }

  std::span<const Point> points_;
  double radius_;
  std::vector<Index> next_;  // in the same cell
  std::unordered_map<Key, Index, ArrayHash> cells_;
};

class AxisMatcher {
 public:
  AxisMatcher(const Lattice& lattice, std::span<const Point> points, std::span<const Index> used,
              double tolerance, const PointGrid& grid, int axis)
      : points_(points), used_(used), tolerance_(tolerance), grid_(grid), axis_(axis) {
    for (const Index v : used) {
      coordinate_.push_back(lattice.coordinates(points[v])[axis]);
      low_ = std::min(low_, coordinate_.back());
      high_ = std::max(high_, coordinate_.back());
    }
    rounding_ = tolerance / lattice.height(axis);
    step_[static_cast<std::size_t>(axis)] = 1;
    shift_ = lattice.shift(step_);
  }

  void run(VertexClasses& classes) {
    if (high_ - low_ < 1 - 2 * rounding_)
      throw InputError("the tile is shorter than its period along " + name() + ": " +
                       std::to_string(high_ - low_) + " of it");
    is_box_ = high_ - low_ <= 1 + 2 * rounding_;
    partner_below_.assign(points_.size(), no_index);
    std::size_t matches = 0;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      if (is_box_ && coordinate_[i] > low_ + 2 * rounding_) continue;
      matches += match(used_[i], classes);
    }
    if (matches == 0)
      throw InputError("no two vertices of the tile are a period apart along " + name() + ", " +
                       text_of(shift_));
    if (!is_box_) return;
    for (std::size_t i = 0; i < used_.size(); ++i)
      if (coordinate_[i] >= high_ - rounding_ && partner_below_[used_[i]] == no_index)
        refuse_lonely(used_[i], points_[used_[i]] - shift_);
  }

 private:
  std::string name() const { return {"xyz"[axis_]}; }

  bool match(Index v, VertexClasses& classes) {
    const Point opposite = points_[v] + shift_;
    grid_.within(opposite, found_);
    if (found_.empty()) {
      if (is_box_) refuse_lonely(v, opposite);
      return false;
    }
    if (found_.size() > 1)
      refuse_ambiguous(v, std::min(found_[0], found_[1]), std::max(found_[0], found_[1]));
    const Index w = found_[0];
    if (partner_below_[w] != no_index) refuse_ambiguous(w, partner_below_[w], v);
    partner_below_[w] = v;
    if (!classes.join(v, w, step_))
      throw InputError("the periods contradict each other at " + vertex_text(v, points_[v]) + " and " +
                       vertex_text(w, points_[w]));
    return true;
  }

  [[noreturn]] void refuse_ambiguous(Index v, Index one, Index other) const {
    throw InputError("periodic sides along " + name() + ": " + vertex_text(v, points_[v]) +
                     " has two partners, " + vertex_text(one, points_[one]) + " and " +
                     vertex_text(other, points_[other]) + ", within " + text(tolerance_) +
                     "; join them, lower the tolerance, or give the pairs");
  }

  [[noreturn]] void refuse_lonely(Index v, const Point& opposite) const {
    Index nearest = no_index;
    double distance = std::numeric_limits<double>::infinity();
    for (const Index w : used_)
      if (const double d = (points_[w] - opposite).norm(); w != v && d < distance) nearest = w, distance = d;
    std::string message = "periodic sides along " + name() + " do not match: " + vertex_text(v, points_[v]) +
                          " has no partner at " + text_of(opposite) + " within " + text(tolerance_);
    if (nearest != no_index)
      message += "; the nearest is vertex " + std::to_string(nearest) + ", at distance " + text(distance);
    throw InputError(message);
  }

  static std::string text(double x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.3g", x);
    return buffer;
  }

  std::span<const Point> points_;
  std::span<const Index> used_;
  double tolerance_;
  const PointGrid& grid_;
  int axis_;
  std::vector<double> coordinate_;  // along the period, in units of it; of used_[i]
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
  double rounding_ = 0;  // the tolerance, in units of the period
  LatticeVector step_{};
  Point shift_;
  bool is_box_ = false;
  std::vector<Index> partner_below_, found_;
};

}  // namespace

void match_sides(const Lattice& lattice, std::span<const Point> points, std::span<const Index> used,
                 double tolerance, VertexClasses& classes) {
  const PointGrid grid(points, used, tolerance);
  for (int axis = 0; axis < 3; ++axis)
    if (lattice.is_periodic(axis)) AxisMatcher(lattice, points, used, tolerance, grid, axis).run(classes);
}

void match_pairs(const Lattice& lattice, std::span<const Point> points,
                 std::span<const std::array<Index, 2>> pairs, double tolerance, VertexClasses& classes) {
  for (const auto& [v, w] : pairs) {
    const std::string name = "periodic pair " + std::to_string(v) + "-" + std::to_string(w);
    if (v >= points.size() || w >= points.size())
      throw InputError(name + ": there are " + std::to_string(points.size()) + " vertices");
    const auto shift = lattice.nearest(points[w] - points[v], tolerance);
    if (!shift)
      throw InputError(name + ": the vertices at " + text_of(points[v]) + " and " + text_of(points[w]) +
                       " are not a lattice vector apart");
    if (!classes.join(v, w, *shift)) throw InputError(name + ": contradicts the pairs before it");
  }
}

}  // namespace multimesh
