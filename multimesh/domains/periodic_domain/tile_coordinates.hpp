// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "multimesh/coordinates.hpp"
#include "multimesh/domains/periodic_domain.hpp"
#include "multimesh/domains/periodic_domain/flat_sides.hpp"

namespace multimesh {

/// The positions of a tile for an algorithm: a vertex moves with all its copies. Each copy lies at the place
/// of the one with the least offset, shifted.
class TileCoordinates final : public Coordinates {
 public:
  /// The domain must outlive it. `keep_flat`: flat sides stay flat.
  TileCoordinates(PeriodicDomain& domain, bool keep_flat);
  NodeId node() const override { return domain_.tile(); }
  Vec3 at(Index v) const override { return domain_.positions()[v]; }
  /// A coordinate that changes only by rounding is left unchanged: flat sides stay flat.
  void set(Index v, const Vec3& x) override;
  Vec3 place_of_copy(Index copy, Index v, const Vec3& x) const override;
  std::vector<Vec3> periods() const override;
  Vec3 image_near(const Vec3& x, const Vec3& p) const override;
  Vec3 allowed(Index v, const Vec3& x) const override { return flat_ ? flat_->allowed(v, x) : x; }
  Vec3 merged(const VertexChange& c) const override;
  /// A place may be given as seen from any copy: each takes the one nearest to its edge.
  void prescribe(Places places) override;
  const std::vector<Vec3>* list(const Vec3*) const override { return &domain_.positions().values(); }

 private:
  PeriodicDomain& domain_;
  std::optional<FlatSides> flat_;
  DartBuffer copies_;
};

/// Makes copies of a vertex equal again: interpolated separately, they differ by rounding. \pre among the
/// attributes of the operations after the domain's own
class CopiesKeepTheirOffsets final : public Attribute {
 public:
  explicit CopiesKeepTheirOffsets(PeriodicDomain& domain) : Attribute(domain.tile()), domain_(domain) {}
  void update(Operation, const VertexChange&) override {}
  void finish(const Event& event) override;
  Mark mark() const override { return 0; }
  void rollback(Mark) override {}
  void forget() override {}

 private:
  PeriodicDomain& domain_;
  std::vector<Index> vertices_;
};

}  // namespace multimesh
