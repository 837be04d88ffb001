// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "multimesh/dart.hpp"
#include "multimesh/geometry/closest_point.hpp"

namespace multimesh::spatial {

/// A facet close to a point, and its closest point to that point.
struct Nearby {
  Index facet = no_index;  ///< number of the triangle, counted from 0
  std::array<double, 3> barycentric{1, 0, 0};
  double squared_distance = 0;
};

/// Finds closest points on a fixed set of triangles, in space or in the UV plane (z = 0), with or without
/// area. The results are exact in double precision; Embree's tree, in single precision, only excludes what is
/// certainly too far away. Where triangles are too small relative to the total extent for that, or a point is
/// too far away, a tree in double precision is used: the time does not depend on the extent. Ties go to the
/// lowest facet. Queries may run on many threads at once.
class TriangleTree {
 public:
  /// Cost: O(n log n), on all cores; about 150 bytes per triangle. \throw InputError naming the triangle if a
  /// coordinate is not finite
  explicit TriangleTree(std::vector<Triangle> triangles);
  ~TriangleTree();
  TriangleTree(TriangleTree&&) noexcept;
  TriangleTree& operator=(TriangleTree&&) noexcept;

  const std::vector<Triangle>& triangles() const;

  /// The closest triangle; none if there is none within `max_distance`, inclusive. A known bound, for
  /// instance the distance to any of the triangles, makes it faster. \throw UsageError if p is not finite
  std::optional<Nearby> nearest(const Vec3& p,
                                double max_distance = std::numeric_limits<double>::infinity()) const;

  /// Whether any triangle is within `max_distance`, inclusive. Stops at the first one found.
  bool has_within(const Vec3& p, double max_distance) const;

  /// Like nearest, but on each triangle the point that `choose` returns counts, with its squared distance to
  /// p; none: the triangle is left out. `choose` is not called for triangles that are too far.
  using Choose = std::function<std::optional<PointOnTriangle>(Index facet)>;
  std::optional<Nearby> nearest_chosen(const Vec3& p, const Choose& choose,
                                       double max_distance = std::numeric_limits<double>::infinity()) const;

  /// All triangles within `radius`, inclusive, by ascending facet. `found` is overwritten; if it is reused,
  /// nothing is allocated in the steady state. \throw UsageError if p is not finite
  void within(const Vec3& p, double radius, std::vector<Nearby>& found) const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

}  // namespace multimesh::spatial
