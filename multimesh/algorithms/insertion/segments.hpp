// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "multimesh/algorithms/insertion/cells.hpp"

namespace multimesh::insertion {

/// How many points were put where.
struct Counts {
  std::size_t faces = 0, edges = 0;  ///< split by segments
  std::size_t planes = 0;            ///< edges split by polygons
  std::size_t swaps = 0;
  std::size_t snapped = 0;
  std::size_t points() const { return faces + edges + planes; }
};

/// Makes segments edges of the tetrahedra, by walking along them:
///
// clang-format off
///      x                    At v, one tetrahedron is entered. The far face is pierced: the face is split there, or
///     / \\                  if the vertex beyond is on the segment, swapped. An edge is met: it is split. A
///  --v---\\-.--------- B    vertex is met: there is nothing to do. Only the ends of the segment and vertices of
///     \   z                 the mesh are asked for the sides: v drops out, because it is on the segment.
///      \ /
///       y
// clang-format on
class SegmentWalk {
 public:
  SegmentWalk(Cells& cells, bool snap, Counts& counts) : cells_(cells), snap_(snap), counts_(counts) {}

  /// Makes a-b a chain of edges. \param beside the polygons that have it as an edge
  void insert(Index a, Index b, std::span<const Index> beside);
  /// The vertices of the chain, from a to b; empty if it is none.
  std::vector<Index> chain(Index a, Index b) const;

 private:
  enum class Meets { vertex, edge, face };
  struct Way {
    Meets what;
    Dart dart;  ///< (v,x,..), (v,y,z,x), or (v,x,y,z): what is met is x, y-z, x-y-z
  };
  Way find_way(Index v, Index a, Index b) const;
  Index meet_edge(const Way& way, Index a, Index b, std::span<const Index> beside);
  Index meet_face(const Way& way, Index a, Index b, std::span<const Index> beside);
  bool is_on_line(Index v, Index a, Index b, Index x, Index y) const;

  Cells& cells_;
  bool snap_;
  Counts& counts_;
  mutable DartBuffer star_;
};

}  // namespace multimesh::insertion
