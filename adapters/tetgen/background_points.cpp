// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/tetgen/background_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>

#include "multimesh/error.hpp"
#include "multimesh/geometry/closest_point.hpp"
#include "multimesh/hash.hpp"

namespace multimesh::tetgen {

namespace {

// Within these, neither TetGen's squares and cubes nor the products in its exact predicates overflow or
// vanish.
constexpr double least_extent = 1e-40, most_extent = 1e40;

/// Factors of the margin, one per side. TetGen 1.5.0 aborts (an assertion of its point location) for one of
/// 60 sets of few points with integer coordinates if the box is symmetric about them, so that its planes and
/// those of the grid pass through them; for none of 8,200 with these.
constexpr double unequal[6] = {1.034, 1.171, 1.093, 1.213, 1.317, 1.409};

using Cell = std::array<std::uint64_t, 3>;

/// Finds whether one of the points is within a radius. Cells are as large as the radius: 27 of them are
/// searched.
class NearPoints {
 public:
  NearPoints(std::span<const Point> points, const Point& origin, double radius)
      : points_(points), origin_(origin), radius_(radius), next_(points.size(), no_index) {
    for (Index i = 0; i < points.size(); ++i) {
      const auto [at, is_new] = first_.try_emplace(cell(points[i]), i);
      if (!is_new) next_[i] = std::exchange(at->second, i);
    }
  }

  bool any(const Point& p) const {
    const Cell c = cell(p);
    for (std::uint64_t x = c[0] - 1; x != c[0] + 2; ++x)
      for (std::uint64_t y = c[1] - 1; y != c[1] + 2; ++y)
        for (std::uint64_t z = c[2] - 1; z != c[2] + 2; ++z)
          if (any_in({x, y, z}, p)) return true;
    return false;
  }

 private:
  Cell cell(const Point& p) const {
    Cell c{};
    for (std::size_t i = 0; i < 3; ++i)
      c[i] = static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor((p[i] - origin_[i]) / radius_)));
    return c;
  }

  bool any_in(const Cell& c, const Point& p) const {
    const auto at = first_.find(c);
    for (Index i = at == first_.end() ? no_index : at->second; i != no_index; i = next_[i])
      if (std::hypot(p[0] - points_[i][0], p[1] - points_[i][1], p[2] - points_[i][2]) < radius_) return true;
    return false;
  }

  std::span<const Point> points_;
  Point origin_;
  double radius_;
  std::unordered_map<Cell, Index, ArrayHash> first_;
  std::vector<Index> next_;
};

/// Marks the nodes of the grid that are nearer than `radius` to a triangle.
class NearTriangles {
 public:
  using Steps = std::array<std::size_t, 3>;
  template <class Node>
  NearTriangles(std::span<const Point> points, const FacetList& triangles, const Box& box, const Steps& steps,
                double radius, const Node& node)
      : steps_(steps), near_((steps[0] + 1) * (steps[1] + 1) * (steps[2] + 1), false) {
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const auto v = triangles.facet(t);
      const std::array<Vec3, 3> p{points[v[0]], points[v[1]], points[v[2]]};
      const Vec3 low = min(min(p[0], p[1]), p[2]), high = max(max(p[0], p[1]), p[2]);
      Steps from{}, to{};
      for (std::size_t i = 0; i < 3; ++i) {
        const double step = (box.high[i] - box.low[i]) / static_cast<double>(steps[i]);
        const auto clamped = [&](double x) {
          return static_cast<std::size_t>(std::clamp(x, 0.0, static_cast<double>(steps[i])));
        };
        from[i] = clamped(std::floor((low[i] - radius - box.low[i]) / step));
        to[i] = clamped(std::ceil((high[i] + radius - box.low[i]) / step));
      }
      for (std::size_t z = from[2]; z <= to[2]; ++z)
        for (std::size_t y = from[1]; y <= to[1]; ++y)
          for (std::size_t x = from[0]; x <= to[0]; ++x)
            if (const std::size_t i = index(x, y, z); !near_[i])
              near_[i] = squared_distance({node(0, x), node(1, y), node(2, z)}, p) < radius * radius;
    }
  }
  bool any(std::size_t x, std::size_t y, std::size_t z) const { return near_[index(x, y, z)]; }

 private:
  static double squared_distance(const Vec3& x, const std::array<Vec3, 3>& p) {
    return spatial::closest_point(x, {p[0], p[1], p[2]}).squared_distance;
  }
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * (steps_[1] + 1) + y) * (steps_[0] + 1) + x;
  }

  Steps steps_;
  std::vector<bool> near_;
};

/// How many steps the grid has along each axis; 1 without one.
std::array<std::size_t, 3> grid_steps(const Box& box, const DelaunayOptions& options, std::size_t points) {
  std::array<std::size_t, 3> steps{1, 1, 1};
  if (options.grid_spacing == 0) return steps;
  double nodes = 1;
  std::array<double, 3> wanted{};
  for (std::size_t i = 0; i < 3; ++i) {
    wanted[i] = std::max(1.0, std::ceil((box.high[i] - box.low[i]) / options.grid_spacing));
    nodes *= wanted[i] + 1;
  }
  constexpr double most = 50e6;  // TetGen would need 50 GB, and int indices
  if (!(nodes + static_cast<double>(points) <= most))
    throw InputError("the grid would have " + std::to_string(nodes) + " nodes: a larger spacing is needed");
  for (std::size_t i = 0; i < 3; ++i) steps[i] = static_cast<std::size_t>(wanted[i]);
  return steps;
}

void check(const DelaunayOptions& o) {
  if (!(o.box_margin >= 0 && o.box_margin <= 100)) throw UsageError("box_margin is not in [0, 100]");
  if (!(o.grid_spacing >= 0 && std::isfinite(o.grid_spacing)))
    throw UsageError("grid_spacing is not a length");
  if (!(o.grid_clearance >= 0 && o.grid_clearance <= 1)) throw UsageError("grid_clearance is not in [0, 1]");
}

}  // namespace

Box background_box(std::span<const Point> points, const DelaunayOptions& options, unsigned attempt) {
  check(options);
  if (points.empty()) return {{0, 0, 0}, {1, 1, 1}};
  Box box{points[0], points[0]};
  for (std::size_t p = 0; p < points.size(); ++p)
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = points[p][i];
      if (!std::isfinite(x)) throw InputError("point " + std::to_string(p) + ": a coordinate is not finite");
      box.low[i] = std::min(box.low[i], x), box.high[i] = std::max(box.high[i], x);
    }
  double diagonal = std::hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
  if (diagonal == 0) diagonal = 1;  // a single place has no extent
  if (!(diagonal >= least_extent && diagonal <= most_extent))
    throw InputError("the points extend over " + std::to_string(diagonal) + ": scale them to about 1");
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] -= unequal[(2 * i + attempt) % 6] * options.box_margin * diagonal;
    box.high[i] += unequal[(2 * i + 1 + attempt) % 6] * options.box_margin * diagonal;
    // TetGen treats points flatter than 1e-8 as flat; so do coordinates far from 0, whose precision is too
    // coarse.
    if (!(box.high[i] - box.low[i] > 1e-7 * diagonal))
      throw InputError("the box of the points is flat along axis " + std::to_string(i) +
                       ": a larger margin is needed, or points nearer to the origin");
  }
  return box;
}

std::vector<Point> background_points(std::span<const Point> points, const Box& box,
                                     const DelaunayOptions& options) {
  const std::array<std::size_t, 3> steps = grid_steps(box, options, points.size());
  const double radius = options.grid_spacing * options.grid_clearance;
  // A radius below the coordinates' own precision only finds equal points, and its cells would overflow.
  double extent = 0;
  for (std::size_t i = 0; i < 3; ++i) extent = std::max(extent, box.high[i] - box.low[i]);
  const NearPoints near(points, box.low, std::max(radius, 1e-12 * extent));

  const auto node = [&](std::size_t axis, std::size_t step) {
    const double t = static_cast<double>(step) / static_cast<double>(steps[axis]);
    return step == steps[axis] ? box.high[axis] : box.low[axis] + t * (box.high[axis] - box.low[axis]);
  };
  const NearTriangles near_triangles(points, options.triangles, box, steps, radius, node);
  std::vector<Point> added;
  for (std::size_t z = 0; z <= steps[2]; ++z)
    for (std::size_t y = 0; y <= steps[1]; ++y)
      for (std::size_t x = 0; x <= steps[0]; ++x) {
        const Point p{node(0, x), node(1, y), node(2, z)};
        const bool is_corner =
            (x == 0 || x == steps[0]) && (y == 0 || y == steps[1]) && (z == 0 || z == steps[2]);
        // The corners stay, so that the box is filled, unless the margin is 0 and a point is there already.
        const bool is_taken = is_corner ? std::find(points.begin(), points.end(), p) != points.end()
                                        : near.any(p) || near_triangles.any(x, y, z);
        if (!is_taken) added.push_back(p);
      }
  return added;
}

std::vector<Index> first_equal(std::span<const Point> points) {
  std::vector<Index> first(points.size());
  std::unordered_map<Cell, Index, ArrayHash> seen;
  seen.reserve(points.size());
  for (Index i = 0; i < points.size(); ++i) {
    Cell bits{};
    for (std::size_t k = 0; k < 3; ++k) bits[k] = std::bit_cast<std::uint64_t>(points[i][k] + 0.0);
    first[i] = seen.try_emplace(bits, i).first->second;
  }
  return first;
}

}  // namespace multimesh::tetgen
