// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/decimate.hpp"

namespace multimesh::decimation {

/// How much a vertex is bound: of two, the merged vertex is the one that is bound more.
enum class Rank : std::uint8_t { free, on_curve, fixed };

/// The kinds of curves that are seams, of all UV sets.
CurveKinds seam_kinds(const TexturedSurface& surface);

/// The curves of a surface, boundary included, as decimation sees them. Ranks follow from what legality
/// holds: they tell it beforehand, cheaply.
class Strata {
 public:
  Strata(const TexturedSurface& surface, const DecimateOptions& options);

  Rank rank(Index v) const { return ranks_[v]; }
  /// Of an edge: boundary, seam, border, or sharp.
  bool is_curve(Dart e) const;
  /// How much the shape of the curve through e counts, relative to the surface's; 0 if there is none.
  double weight(Dart e) const;
  /// Whether a collapse of the edge may be legal, as far as the ranks tell: not so for a chord between
  /// curves.
  bool may_collapse(Dart e, Index a, Index b) const {
    return ranks_[a] != ranks_[b] || ranks_[a] == Rank::free || is_curve(e);
  }
  void merge(Index kept, Index gone) { ranks_[kept] = std::max(ranks_[kept], ranks_[gone]); }

 private:
  void rank_curves();
  void rank_fixed_points();

  const TexturedSurface& surface_;
  const MultiMesh& tree_;
  const Mesh& root_;
  double curve_weight_, seam_weight_;
  CurveKinds seam_kinds_;
  std::vector<Rank> ranks_;
};

}  // namespace multimesh::decimation
