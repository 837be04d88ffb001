// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>

#include "multimesh/dart.hpp"
#include "multimesh/geometry/closest_point.hpp"

namespace multimesh::spatial {

/// A few triangles that are queried together for those within a distance of a point. A triangle is convex and
/// so is the distance from it: if it is near the corners of another triangle, it is near all of that
/// triangle.
class NearTriangles {
 public:
  using Mask = std::uint64_t;  ///< bit i stands for triangle i
  static constexpr std::size_t capacity = 64;

  struct Near {
    Mask mask = 0;
    std::size_t nearest = 0;  ///< among those in the mask
  };

  explicit NearTriangles(double distance) : distance_(distance), squared_distance_(distance * distance) {}

  std::size_t size() const { return size_; }
  Index name(std::size_t i) const { return entries_[i].name; }
  /// \pre size() < capacity
  void add(Index name, const Triangle& triangle);
  /// Forgets all but the first n.
  void shrink(std::size_t n) { size_ = n; }

  /// Of the triangles from `first` on, those near p; at exactly that distance, rounding decides.
  Near near(const Vec3& p, std::size_t first = 0) const;
  /// Going from p to q, t = 0 to 1: the last t at which the path leaves one of these triangles above or below
  /// which p lies; 0 if there is none, 1 if one reaches as far as q.
  double leaves(Mask triangles, const Vec3& p, const Vec3& q) const;

 private:
  /// A triangle with unit vectors, or 0 if it has no area: its normal, and those in its plane that point
  /// outwards across edge i, which goes from corner i to i+1.
  struct Entry {
    Index name;
    Triangle triangle;
    Vec3 normal;
    std::array<Vec3, 3> outward;
    bool is_fat;  ///< enough for its normal to be exact
  };
  static Entry entry(Index name, const Triangle& triangle);
  static double leaves(const Entry& e, const Vec3& p, const Vec3& q);
  double squared_distance(const Entry& e, const Vec3& p) const;

  double distance_, squared_distance_;
  std::size_t size_ = 0;
  std::array<Entry, capacity> entries_;
};

}  // namespace multimesh::spatial
