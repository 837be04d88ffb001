// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/copy.hpp"
#include "multimesh/embedding.hpp"

namespace multimesh::decimation {

/// How much a vertex is bound: of two, the merged vertex is the one that is bound more.
enum class Rank : std::uint8_t {
  free,
  on_curve,
  fixed,
  locked,  ///< by the options; two of these are never merged
};

/// The curves of a surface, boundary included, as decimation sees them. Ranks follow from what legality
/// holds: they tell it beforehand, cheaply.
class Strata {
 public:
  /// Cost: linear.
  Strata(const EmbeddedMesh& surface, const DecimateOptions& options);

  Rank rank(Index v) const { return ranks_[v]; }
  /// Of an edge: whether anything runs along it, in any mesh.
  bool is_curve(Dart e) const { return lines_[mesh_.simplex(e, 1)] != Line::none; }
  /// How much the shape of the curve through e counts, relative to the surface's; 0 if there is none.
  double weight(Dart e) const;
  /// Whether a collapse of the edge may be legal, as far as the ranks tell: not so for a chord between
  /// curves.
  bool may_collapse(Dart e, Index a, Index b) const {
    return ranks_[a] != ranks_[b] || ranks_[a] == Rank::free || (ranks_[a] != Rank::locked && is_curve(e));
  }
  /// All edges of the surface that are this one in the root, e first: where sheets meet, each has its own.
  /// They begin with the same end.
  void sheets(Dart e, Index a, Index b, DartBuffer& out) const;
  /// Whether there may be others than e.
  bool has_sheets() const noexcept { return surface_.node() != NodeId::root; }
  /// After a collapse. `renew`: edges with anything along them may have been among those that became one.
  void merge(Index kept, Index gone, bool renew);

 private:
  enum class Line : std::uint8_t {
    none,
    seam,  ///< charts are cut open there, and nothing else is
    shape,
  };
  /// Asked of the maps.
  Line line(Dart e) const;
  Line line_of(const Copy& copy, std::size_t copies) const;
  bool is_seam(Dart e) const;
  std::vector<Index> find_curves() const;
  std::vector<bool> special_vertices(const std::vector<Index>& curves) const;
  void rank_vertices(const std::vector<Index>& curves);
  void lock(const DecimateOptions& options);

  const EmbeddedMesh& surface_;
  const MultiMesh& tree_;
  const Mesh& mesh_;
  double curve_weight_, seam_weight_;
  std::vector<Rank> ranks_;
  std::vector<Line> lines_;  // per edge, as line() would say
  mutable Copies copies_;
  DartBuffer edges_;
};

}  // namespace multimesh::decimation
