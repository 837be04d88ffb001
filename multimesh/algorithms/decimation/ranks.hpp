// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/column.hpp"
#include "multimesh/embedding.hpp"
#include "multimesh/strata.hpp"

namespace multimesh::decimation {

/// How much a vertex is bound: of two, the merged vertex is the one that is bound more.
enum class Rank : std::uint8_t {
  free,
  on_curve,
  fixed,
  locked,  ///< by the options, or at something that stays; two of these are never merged
};

/// How much each vertex of a surface is bound, and how much the shape of each edge's curve counts, boundary
/// included. Strata finds both once; then they follow the operations as columns. Ranks follow from what
/// legality and invariants refuse: they tell it beforehand, cheaply.
class Ranks {
 public:
  /// Adds its columns to the operations of the surface. Cost: linear.
  Ranks(EmbeddedMesh& surface, const DecimateOptions& options);

  Rank rank(Index v) const { return ranks_[v]; }
  bool is_curve(Dart e) const { return curves_[mesh_.simplex(e, 1)] != plain; }
  /// How much the shape of the curve through e counts, relative to the surface's; 0 if there is none.
  double weight(Dart e) const { return weights_[curves_[mesh_.simplex(e, 1)]]; }
  /// Whether a collapse of the edge may be legal, as far as the ranks tell: not so for a chord between
  /// curves.
  bool may_collapse(Dart e, Index a, Index b) const {
    return ranks_[a] != ranks_[b] || ranks_[a] == Rank::free || (ranks_[a] != Rank::locked && is_curve(e));
  }
  /// Strata::sheets. A vertex inside a sheet is in no other one.
  void sheets(Dart e, Index a, Index b, DartBuffer& out) const {
    if (ranks_[a] == Rank::free || ranks_[b] == Rank::free) return out.assign(1, e);
    strata_.sheets(e, out);
  }
  /// Whether there may be others than e.
  bool has_sheets() const noexcept { return has_sheets_; }
  const Strata& strata() const noexcept { return strata_; }
  /// What other operations on the tree have to carry.
  std::array<Attribute*, 2> columns() { return {&curve_column_, &rank_column_}; }

 private:
  enum Curve : Index { plain, seam, shape };
  void find_curves();
  void rank_vertices();
  void lock(bool boundary, bool seams);
  void lock_what_stays();
  void lock_kept_edges(const MultiMesh& tree, NodeId node);

  const Mesh& mesh_;
  bool has_sheets_;
  std::array<double, 3> weights_;
  Strata strata_;
  std::vector<Index> curves_;  // per edge: what runs along it, in any mesh
  std::vector<Rank> ranks_;
  Column<Index> curve_column_;
  VertexAttribute<Rank> rank_column_;
};

}  // namespace multimesh::decimation
