// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>

#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh {

/// The sides of a tile that lie in one plane each (of triangles: on one line), and are to stay there.
class FlatSides {
 public:
  /// Cost: linear.
  explicit FlatSides(const PeriodicDomain& domain);

  /// Whether there is no other side.
  bool are_all() const { return all_; }
  /// The nearest place to x where the vertex of the tile, as it is now, stays in its flat sides.
  Vec3 allowed(Index v, const Vec3& x) const;

 private:
  std::optional<Vec3> normal_of(const PeriodicSide& side, const PeriodicTile& tile) const;
  bool is_flat(const PeriodicSide& side, const PeriodicTile& tile, const Vec3& normal) const;
  std::vector<Vec3> normals_at(Index v) const;

  const PeriodicDomain& domain_;
  Vec3 tile_normal_;
  bool all_ = true;
  std::map<LatticeVector, Vec3> normals_;  ///< of flat sides, by the vector between the two
};

}  // namespace multimesh
