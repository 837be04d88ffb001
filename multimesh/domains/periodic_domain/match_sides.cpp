// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/domains/periodic_domain/match_sides.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <tuple>
#include <unordered_map>

#include "multimesh/error.hpp"
#include "multimesh/hash.hpp"

namespace multimesh {

namespace {

std::string vertex_text(Index v, const Vec3& p) {
  return "vertex " + std::to_string(v) + " at " + text_of(p);
}

/// Points in cells of twice the search radius: a ball around a point reaches into eight cells at most.
class PointGrid {
 public:
  PointGrid(std::span<const Vec3> points, std::span<const Index> used, double radius)
      : points_(points), radius_(radius), next_(points.size(), no_index) {
    cells_.reserve(used.size());
    for (const Index v : used) {
      Index& first = cells_.try_emplace(cell(points[v]), no_index).first->second;
      next_[v] = first;
      first = v;
    }
  }

  /// All points within the radius of p.
  void within(const Vec3& p, std::vector<Index>& out) const {
    out.clear();
    const Vec3 reach{radius_, radius_, radius_};
    const Key low = cell(p - reach), high = cell(p + reach);
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
  Key cell(const Vec3& p) const {
    const auto along = [&](std::size_t i) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(p[i] / (2 * radius_))));
    };
    return {along(0), along(1), along(2)};
  }

  std::span<const Vec3> points_;
  double radius_;
  std::vector<Index> next_;  // in the same cell
  std::unordered_map<Key, Index, ArrayHash> cells_;
};

std::string text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", x);
  return buffer;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void add(double x) { low = std::min(low, x), high = std::max(high, x); }
  double extent() const { return high - low; }
};

bool is_positive(const LatticeVector& v) {
  return v > LatticeVector{};
}

/// Lines across a lattice: integer combinations of its coordinates. Along one, the tile has an extent in
/// layers of the lattice.
double along(const LatticeVector& direction, const Vec3& coordinates) {
  return direction[0] * coordinates[0] + direction[1] * coordinates[1] + direction[2] * coordinates[2];
}
int along(const LatticeVector& direction, const LatticeVector& v) {
  return direction[0] * v[0] + direction[1] * v[1] + direction[2] * v[2];
}

class SideMatcher {
 public:
  SideMatcher(const Lattice& lattice, std::span<const Vec3> points, std::span<const Index> used,
              std::span<const LatticeVector> vectors, double tolerance)
      : lattice_(lattice),
        points_(points),
        used_(used),
        vectors_(vectors),
        tolerance_(tolerance),
        grid_(points, within_reach(), tolerance) {}

  void run(VertexClasses& classes) {
    for (const LatticeVector& shift : vectors_) match_along(shift, classes);
    for (int axis = 0; axis < 3; ++axis)
      if (lattice_.is_periodic(axis)) require_match(axis);
    for (const LatticeVector& direction : directions()) require_complete(direction);
  }

 private:
  struct Match {
    Index from, to;
    LatticeVector shift;
  };

  /// The vertices that a lattice vector leads to from within the box.
  std::vector<Index> within_reach() {
    for (const Index v : used_) low_ = min(low_, points_[v]), high_ = max(high_, points_[v]);
    std::vector<Vec3> shifts;
    for (const LatticeVector& v : vectors_) shifts.push_back(lattice_.shift(v));
    std::vector<Index> list;
    for (const Index v : used_)
      if (std::ranges::any_of(shifts, [&](const Vec3& by) { return is_near_box(points_[v] - by); }))
        list.push_back(v);
    return list;
  }

  bool is_periodic(const LatticeVector& d) const {
    for (int i = 0; i < 3; ++i)
      if (d[static_cast<std::size_t>(i)] != 0 && !lattice_.is_periodic(i)) return false;
    return true;
  }
  /// Those along an axis first.
  std::vector<LatticeVector> directions() const {
    std::vector<LatticeVector> all{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int x = 0; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z)
          if (const LatticeVector d{x, y, z}; is_positive(d) && std::abs(x) + std::abs(y) + std::abs(z) > 1)
            all.push_back(d);
    std::erase_if(all, [&](const LatticeVector& d) { return !is_periodic(d); });
    return all;
  }
  bool is_near_box(const Vec3& p) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(p[i] >= low_[i] - tolerance_ && p[i] <= high_[i] + tolerance_)) return false;
    return true;
  }

  void match_along(const LatticeVector& shift, VertexClasses& classes) {
    const Vec3 by = lattice_.shift(shift);
    const std::size_t first = matches_.size();
    for (const Index v : used_) {
      const Vec3 opposite = points_[v] + by;
      if (!is_near_box(opposite)) continue;
      grid_.within(opposite, found_);
      if (found_.empty()) continue;
      if (found_.size() > 1) refuse_ambiguous(shift, v, found_[0], found_[1]);
      matches_.push_back({v, found_[0], shift});
    }
    std::sort(matches_.begin() + static_cast<std::ptrdiff_t>(first), matches_.end(),
              [](const Match& m, const Match& n) { return std::tie(m.to, m.from) < std::tie(n.to, n.from); });
    for (std::size_t i = first; i < matches_.size(); ++i) {
      const Match& m = matches_[i];
      if (i > first && matches_[i - 1].to == m.to)
        refuse_ambiguous(shift, m.to, matches_[i - 1].from, m.from);
      if (!classes.join(m.from, m.to, shift))
        throw InputError("the periods contradict each other at " + vertex_text(m.from, points_[m.from]) +
                         " and " + vertex_text(m.to, points_[m.to]));
    }
  }

  void require_match(int axis) const {
    const auto i = static_cast<std::size_t>(axis);
    if (std::any_of(matches_.begin(), matches_.end(), [i](const Match& m) { return m.shift[i] != 0; }))
      return;
    LatticeVector unit{};
    unit[i] = 1;
    throw InputError("no two vertices of the tile are a period apart along " + name_of(unit) + ", " +
                     text_of(lattice_.shift(unit)));
  }

  /// If the tile lies within one layer of the lattice in this direction, both of its sides must match.
  void require_complete(const LatticeVector& direction) const {
    const double rounding = tolerance_ / lattice_.spacing(direction);
    Range range;
    for (const Index v : used_) range.add(along(direction, lattice_.coordinates(points_[v])));
    if (std::abs(range.extent() - 1) > 2 * rounding) return;
    std::vector<bool> has_partner(points_.size(), false);
    for (const Match& m : matches_)
      if (along(direction, m.shift) != 0) has_partner[m.from] = has_partner[m.to] = true;
    for (const Index v : used_) {
      if (has_partner[v]) continue;
      const double x = along(direction, lattice_.coordinates(points_[v]));
      if (x <= range.low + 2 * rounding) refuse_lonely(direction, v, 1);
      if (x >= range.high - rounding) refuse_lonely(direction, v, -1);
    }
  }

  [[noreturn]] void refuse_ambiguous(const LatticeVector& shift, Index v, Index one, Index other) const {
    const auto [first, second] = std::minmax(one, other);
    throw InputError("periodic sides along " + name_of(shift) + ": " + vertex_text(v, points_[v]) +
                     " has two partners, " + vertex_text(first, points_[first]) + " and " +
                     vertex_text(second, points_[second]) + ", within " + text(tolerance_) +
                     "; join them, lower the tolerance, or give the pairs");
  }

  /// `sign`: whether the partner is missing in the direction or against it.
  [[noreturn]] void refuse_lonely(const LatticeVector& direction, Index v, int sign) const {
    Index nearest = no_index;
    double distance = std::numeric_limits<double>::infinity();
    std::optional<Vec3> missing;
    for (const LatticeVector& shift : vectors_) {
      const int steps = along(direction, shift);
      if (std::abs(steps) != 1) continue;
      const Vec3 opposite = points_[v] + double(sign * steps) * lattice_.shift(shift);
      if (!is_near_box(opposite)) continue;
      for (const Index w : used_) {
        const double d = (points_[w] - opposite).norm();
        if (w == v || d >= distance) continue;
        nearest = w, distance = d, missing = opposite;
      }
    }
    std::string message = "periodic sides along " + name_of(direction) +
                          " do not match: " + vertex_text(v, points_[v]) + " has no partner";
    if (missing)
      message += " at " + text_of(*missing) + " within " + text(tolerance_) + "; the nearest is vertex " +
                 std::to_string(nearest) + ", at distance " + text(distance);
    throw InputError(message);
  }

  const Lattice& lattice_;
  std::span<const Vec3> points_;
  std::span<const Index> used_;
  std::span<const LatticeVector> vectors_;
  double tolerance_;
  Vec3 low_{HUGE_VAL, HUGE_VAL, HUGE_VAL}, high_ = -low_;
  PointGrid grid_;
  std::vector<Match> matches_;
  std::vector<Index> found_;
};

}  // namespace

std::vector<LatticeVector> vectors_within(const Lattice& lattice, std::span<const Vec3> points,
                                          std::span<const Index> used, double tolerance) {
  constexpr int most = 50;         // periods per tile: more are a mistake in units
  constexpr double margin = 1.05;  // for sides that nearly meet: open_sides.hpp
  std::array<Range, 3> box, coordinate;
  for (const Index v : used) {
    const Vec3 c = lattice.coordinates(points[v]);
    for (std::size_t i = 0; i < 3; ++i) {
      box[i].add(points[v][i]);
      coordinate[i].add(c[i]);
    }
  }
  LatticeVector steps{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int axis = static_cast<int>(i);
    if (!lattice.is_periodic(axis)) continue;
    const double extent = coordinate[i].extent(), rounding = tolerance / lattice.height(axis);
    const std::string name{"xyz"[i]};
    if (extent < 1 - 2 * rounding)
      throw InputError("the tile is shorter than its period along " + name + ": " + std::to_string(extent) +
                       " of it");
    if (extent > most)
      throw InputError("the tile is " + text(extent) + " times as long as its period along " + name +
                       "; a tile is one cell of the pattern");
    steps[i] = static_cast<int>(std::floor(margin * extent));
  }
  std::vector<LatticeVector> vectors;
  for (int x = 0; x <= steps[0]; ++x)
    for (int y = -steps[1]; y <= steps[1]; ++y)
      for (int z = -steps[2]; z <= steps[2]; ++z) {
        const LatticeVector v{x, y, z};
        const Vec3 shift = lattice.shift(v);
        bool reaches = is_positive(v);
        for (std::size_t i = 0; i < 3; ++i)
          reaches = reaches && std::abs(shift[i]) <= margin * box[i].extent() + tolerance;
        if (reaches) vectors.push_back(v);
      }
  return vectors;
}

void match_sides(const Lattice& lattice, std::span<const Vec3> points, std::span<const Index> used,
                 std::span<const LatticeVector> vectors, double tolerance, VertexClasses& classes) {
  SideMatcher(lattice, points, used, vectors, tolerance).run(classes);
}

void match_pairs(const Lattice& lattice, std::span<const Vec3> points,
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
