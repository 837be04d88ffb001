// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <unordered_set>
#include <vector>

#include "multimesh/algorithms/insertion/polygons.hpp"
#include "multimesh/algorithms/insertion/segments.hpp"

namespace multimesh::insertion {

/// Makes polygons, whose edges are chains of edges already, unions of faces. A front of directed edges, at
/// first the polygon's boundary, moves into it: around each edge (u,w), between x below the plane and y above
/// it, the edge x-y is split in the plane; where x or y is in the plane, there is a face already. It is
/// taken, and its other two edges replace (u,w), or take away those that run against them. No edge of the
/// mesh that a split makes crosses the plane again: it ends.
class Front {
 public:
  Front(Cells& cells, const SegmentWalk& walk, bool snap, Counts& counts)
      : cells_(cells), walk_(walk), snap_(snap), counts_(counts) {}

  using Face = std::array<Index, 3>;
  /// The faces of the polygon, oriented as it is. Splits edges if allowed; otherwise, if the polygon is not
  /// made of faces, there are none.
  std::vector<Face> cover(const Polygon& polygon, Index number, bool may_split);

 private:
  struct Found {
    Index vertex;  ///< no_index: the polygon is not made of faces
    Dart face;     ///< (u, w, vertex, ..)
  };
  static std::uint64_t key(Index u, Index w) { return std::uint64_t{u} << 32U | w; }
  bool start(const Polygon& polygon);
  Found find(const Polygon& polygon, Index number, const Edge& edge, bool may_split);
  Dart face_with(Index u, Index w, Index c);
  Index split(const Polygon& polygon, Index number, Dart crossing);
  void add(Index from, Index to);

  Cells& cells_;
  const SegmentWalk& walk_;
  bool snap_;
  Counts& counts_;
  std::vector<Edge> waiting_;
  std::unordered_set<std::uint64_t> open_;
  DartBuffer ring_;
};

}  // namespace multimesh::insertion
