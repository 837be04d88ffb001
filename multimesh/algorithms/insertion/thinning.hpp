// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/algorithms/insertion/cells.hpp"

namespace multimesh::insertion {

/// Takes out vertices that the insertion made, where the surface is the same set of points without them: one
/// inside a segment goes to its neighbour along it, one inside a polygon to one in its plane, one where
/// planes cross along their line. All tetrahedra stay positive. Long thin triangles make points whose edges
/// the next segments pierce, again and again; this ends it.
class Thinning {
 public:
  /// \param first vertices from this one on may be removed
  Thinning(Cells& cells, Index first) : cells_(cells), first_(first), looked_at_(first) {}

  /// Tries those that were made since the last call; again, until few go. \return how many are gone
  std::size_t run();

 private:
  struct Around {
    std::vector<Index> neighbours;            ///< ascending
    std::vector<Index> along;                 ///< of these, those at edges in segments
    std::vector<std::array<Index, 2>> faces;  ///< in polygons, without the vertex
  };
  void look_around(Index v);
  bool may_go_to(Index v, Index p) const;
  bool remove(Index v);

  Cells& cells_;
  Index first_, looked_at_;
  Around around_;
  DartBuffer star_;
};

}  // namespace multimesh::insertion
