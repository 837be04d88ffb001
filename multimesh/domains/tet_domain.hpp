// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "multimesh/geometry/vector.hpp"
#include "multimesh/multi_mesh.hpp"
#include "multimesh/tet/tet_mesh.hpp"

namespace multimesh {

class Embedding;

/// Bits of the flags of a simplex in the lists below.
enum TetDomainFlag : std::uint8_t {
  feature_simplex = 1,   ///< a point that is a corner, an edge that is a ridge
  required_simplex = 2,  ///< must be kept as it is
  unlisted_simplex = 4,  ///< in the surface or the curves, but not listed by the input
};

/// Tetrahedra with regions, and what is tagged inside them, as plain lists: the contents of a file.
struct TaggedTetrahedra {
  using Tag = std::int32_t;
  std::vector<std::array<double, 3>> points;
  FacetList tets{3, 0, {}};             ///< into points
  std::vector<Tag> regions;             ///< per tetrahedron, or empty: all 0
  std::vector<std::uint8_t> tet_flags;  ///< per tetrahedron, or empty: none; so are all flags
  FacetList triangles{2, 0, {}};        ///< faces of the tetrahedra to keep
  std::vector<Tag> patches;             ///< per triangle, or empty: all 0
  std::vector<std::uint8_t> triangle_flags;
  FacetList edges{1, 0, {}};   ///< edges of the tetrahedra to keep
  std::vector<Tag> edge_tags;  ///< per edge, or empty: all 0
  std::vector<std::uint8_t> edge_flags;
  std::vector<Index> fixed;     ///< points that must keep their place
  std::vector<Tag> fixed_tags;  ///< per fixed point, or empty: all 0
  std::vector<std::uint8_t> fixed_flags;
  std::vector<Tag> point_tags;  ///< per point, or empty: all 0
};

struct TetDomainOptions {
  bool boundary = true;    ///< the boundary is part of the surface
  bool interfaces = true;  ///< so are the faces between tetrahedra of different regions
  /// Edges of the surface whose two faces make an angle of at least this, in radians, become curves.
  double feature_angle = std::numeric_limits<double>::infinity();
};

/// What had to be changed in the input, and what of it was left out.
struct TetDomainReport {
  std::size_t copied_vertices = 0;    ///< copies made of points at which the mesh is not manifold
  std::size_t reversed_tets = 0;      ///< reversed to agree with their neighbours or to have positive volume
  std::size_t inverted_tets = 0;      ///< with negative or no volume, after that
  std::size_t missing_triangles = 0;  ///< tagged triangles that are not a face of a tetrahedron
  std::size_t missing_edges = 0;      ///< tagged edges that are not an edge of a tetrahedron
  std::size_t missing_points = 0;     ///< fixed points that are not a vertex of a tetrahedron
  std::size_t unused_points = 0;      ///< all such points
};

/// A simulation domain as a multimesh:
///
///               tetrahedra
///           /        |        \.
///     surface     curves     fixed points
///
/// Surface: the boundary, the interfaces between regions and the tagged triangles, one triangle mesh, cut
/// where sheets meet. Curves: edges of the surface at which not just two of its faces meet, or faces of
/// different patches, or a listed and an unlisted one, or at an angle; and tagged edges. Chains of curves end
/// where they branch or their kind changes. Fixed points: those that are listed, those where sheets or curves
/// touch and no other mesh guards that, and copies of one input point. Each of the three exists only if it
/// has facets.
///
/// At a point whose link is neither a sphere nor a disk, the cut also separates a few faces inside the
/// material; they are not part of the surface, but of the root's boundary. Copies are locked as well, since
/// they are to be joined again.
class TetDomain {
 public:
  using Point = Vec3;
  using Tag = TaggedTetrahedra::Tag;

  /// \throw InputError naming the element for indices out of range, a repeated vertex, lists of the wrong
  /// length, or if there is no tetrahedron. Cost: sorting
  explicit TetDomain(const TaggedTetrahedra& input, const TetDomainOptions& options = {});
  ~TetDomain();
  TetDomain(TetDomain&&) noexcept;

  /// The current domain. Copies of one input point are one again, unless they have moved apart or a
  /// tetrahedron joins them.
  /// Triangles: the whole surface with its patches, except the part of the boundary that has tag 0 and was
  /// not in the input. Edges: all curves with their tags. Fixed: the fixed points. Interfaces, curves and
  /// fixed points that the input does not list are unlisted_simplex.
  TaggedTetrahedra tagged() const;

  MultiMesh& tree();
  const MultiMesh& tree() const;
  /// Its points; tetrahedra stay positive, simplices that the input requires stay as they are, and copies of
  /// one point can be joined again. Must not outlive the domain. Cost: linear
  Embedding embedding();
  tet::TetMesh& mesh();
  const tet::TetMesh& mesh() const;
  std::optional<NodeId> surface() const;
  std::optional<NodeId> curves() const;
  std::optional<NodeId> fixed_points() const;
  const TetDomainReport& report() const;

  tet::Property<Point>& points();  ///< of the vertices of the root
  const tet::Property<Point>& points() const;
  tet::Property<Tag>& regions();
  const tet::Property<Tag>& regions() const;
  /// Whether cutting made several vertices of this one's point.
  bool is_copy(Index vertex) const;
  /// A number that is equal for exactly the vertices of the root that are copies of one point.
  Index joined_point(Index vertex) const;
  /// Whether cutting made several copies of this edge, or of a face that it is a side of. Changing only one
  /// of the copies leaves the others behind, and the mesh is no longer conforming when it is joined again:
  /// neither split, swap nor collapse such an edge, and move none of its ends.
  bool is_copied_edge(Dart edge) const;
  /// Whether cutting made several of this face: inside the domain, but in the boundary of the root.
  bool is_parted_face(Dart face) const;
  Tag patch(Index triangle) const;   ///< of a triangle of the surface
  Tag curve_tag(Index edge) const;   ///< of an edge of the curves
  Tag fixed_tag(Index point) const;  ///< of a fixed point
  /// TetDomainFlag bits of a tetrahedron of the root, a triangle of the surface, an edge of the curves, a
  /// fixed point. Halves of a split simplex have those of the whole. \pre dimension is 0 to 3
  std::uint8_t flags(int dimension, Index simplex) const;

  struct Data;  ///< private to the implementation

 private:
  std::unique_ptr<Data> data_;
};

}  // namespace multimesh
