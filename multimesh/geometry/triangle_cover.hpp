// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "multimesh/geometry/near_triangles.hpp"
#include "multimesh/geometry/witnesses.hpp"

namespace multimesh::spatial {

/// A point of a triangle, and the candidates near it.
struct CoveredCorner {
  Vec3 position;
  NearTriangles::Near near;
};
using CoveredPart = std::array<CoveredCorner, 3>;

/// Chooses a few candidates that together are near all of a triangle: it is cut in two until each part has
/// one near its three corners, and so near all of it. Gives up, which is on the safe side, after some cuts,
/// or where more than Witnesses::most would be needed. Source: the idea of bounding a distance by parts,
/// Klein, Liebich, Strasser 1996
class TriangleCover {
 public:
  /// `candidates` must outlive it, and not change.
  explicit TriangleCover(const NearTriangles& candidates) : candidates_(candidates) {}

  CoveredCorner corner(const Vec3& p) const { return {p, candidates_.near(p)}; }
  /// Adds to the chosen ones. \return false if it gave up
  bool find(const CoveredPart& part, NearTriangles::Mask& chosen) const;

  /// Of the candidates near all of a part, one that is the nearest at a corner, if possible: what moves away
  /// least will serve longest.
  static NearTriangles::Mask choose(NearTriangles::Mask near_all, const std::array<std::size_t, 3>& nearest);
  Witnesses::Set named(NearTriangles::Mask chosen) const;

 private:
  bool find(const CoveredPart& part, int bisections, NearTriangles::Mask& chosen) const;
  static std::size_t edge_to_divide(const CoveredPart& part);
  CoveredCorner divide(const CoveredCorner& p, const CoveredCorner& q) const;

  const NearTriangles& candidates_;
};

}  // namespace multimesh::spatial
