// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/geometry/box_tree.hpp"

namespace multimesh::spatial {

/// All points within a distance of a surface. Whether a triangle lies inside is decided on the safe side: it
/// is cut in two until each part has one triangle of the surface near its three corners, and so near all of
/// it (the distance from a convex set is convex); parts smaller than an eighth of the distance count as
/// outside.
class Envelope {
 public:
  /// \pre distance > 0, triangles finite. Cost: O(n log n)
  Envelope(std::vector<Triangle> surface, double distance);

  double distance() const noexcept { return distance_; }
  /// What is inside by rounding errors is inside.
  bool contains(const Triangle& t) const;
  bool contains(const Vec3& p) const { return near(p).size > 0; }
  /// The closest point of the surface. \pre the surface has triangles
  Vec3 closest(const Vec3& p) const;

 private:
  /// The triangles near a point, ascending. If there are too many, some are left out.
  struct Near {
    static constexpr std::size_t room = 32;
    std::array<Index, room> triangles;
    std::size_t size = 0;
  };
  struct Corner {
    Vec3 position;
    Near near;
  };
  Near near(const Vec3& p) const;
  bool contains(const Corner& a, const Corner& b, const Corner& c) const;

  std::vector<Triangle> triangles_;
  BoxTree tree_;
  double distance_, squared_distance_, smallest_;
};

}  // namespace multimesh::spatial
