// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>
#include <vector>

#include "multimesh/exact/point.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh::insertion {

/// The tetrahedra into which polygons are inserted, all of positive volume, exactly.
class Cells {
 public:
  /// \pre positively oriented and manifold
  Cells(const FacetList& tets, std::span<const std::array<double, 3>> points);

  const tet::TetMesh& mesh() const noexcept { return mesh_; }
  std::size_t size() const noexcept { return points_.size(); }
  const exact::Point& point(Index v) const { return points_[v]; }

  // --- what is known of vertices, edges and faces; halves keep it
  /// Polygons in whose planes the vertex is known to lie, ascending.
  const std::vector<Index>& planes(Index v) const { return planes_[v]; }
  void add_plane(Index v, Index polygon);
  /// The sign of the side of a plane, through three points of the input, on which the vertex lies.
  int side(Index polygon, const std::array<Index, 3>& plane, Index v) const;
  bool is_on_segment(Dart edge) const { return mesh_.value(segments_, edge) != nullptr; }
  void mark_segment(Dart edge) { mesh_.set_value(segments_, edge, char{1}); }
  bool is_in_polygon(Dart face) const { return mesh_.value(faces_, face) != nullptr; }
  void mark_face(Dart face) { mesh_.set_value(faces_, face, char{1}); }
  /// Whether a face around the edge is in a polygon.
  bool is_beside_polygon(Dart edge) const;

  // --- darts
  int orientation(Index a, Index b, Index c, Index d) const {
    return exact::orient3d(points_[a], points_[b], points_[c], points_[d]);
  }
  /// The vertices of the tetrahedron in the order of the dart, the last two exchanged if it runs negatively.
  Dart positive(Dart d) const;
  std::array<Index, 4> corners(Dart d) const;
  /// A dart (a, b, ..); no_dart if there is no such edge.
  Dart find_edge(Index a, Index b) const;
  /// The same in the star of a.
  Dart find_edge(const DartBuffer& star, Index b) const;

  // --- operations
  /// Whether all tetrahedra stay positive if the edge, or the face, is split there.
  bool may_split_edge(Dart edge, const exact::Point& at) const;
  bool may_split_face(Dart face, const exact::Point& at) const;
  /// \return the new vertex, known to lie in these planes
  Index split_edge(Dart edge, exact::Point at, std::vector<Index> planes);
  Index split_face(Dart face, exact::Point at, std::vector<Index> planes);
  /// Replaces the tetrahedra on both sides of a face by those around the edge between their apexes. \pre that
  /// edge passes through the interior of the face
  void swap_face(Dart face);
  /// Merges v into its neighbour p, if the mesh stays a complex and all tetrahedra positive.
  bool collapse(Index v, Index p);
  /// Common planes of vertices.
  std::vector<Index> common_planes(std::span<const Index> vertices) const;

  /// Puts exact points at their nearest doubles, or at others up to 512 units in the last place away, where
  /// all tetrahedra stay positive. Vertices from `first` on may be moved as far to make room.
  /// \return how many remain
  std::size_t round(Index first);
  std::size_t exact_points() const;

 private:
  Index add_vertex(Index v, exact::Point at, std::vector<Index> planes);
  bool round(Index v, double steps);
  bool round_with_a_neighbour(Index v, Index first);
  bool may_move(Index v, const exact::Point& to) const;

  tet::TetMesh mesh_;
  std::vector<exact::Point> points_;
  std::vector<std::vector<Index>> planes_;
  tet::SimplexProperty<char>& segments_;
  tet::SimplexProperty<char>& faces_;
  SplitRecord split_;
  CollapseRecord collapse_;
  mutable DartBuffer star_;
};

}  // namespace multimesh::insertion
