// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "multimesh/build.hpp"
#include "multimesh/domains/periodic_domain/lattice.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

/// A cell of a periodic pattern as plain lists: triangles or tetrahedra in a box that need not fill it
/// (holes, microstructures). Vertices on opposite sides are different ones, at the same places but for a
/// period.
struct PeriodicTile {
  using Region = std::int32_t;
  std::vector<std::array<double, 3>> points;
  FacetList facets;               ///< dimension 2 or 3, into points
  std::vector<Region> regions{};  ///< per facet, or empty: all 0
};

struct PeriodicOptions {
  /// Along which of x, y, z the tile is periodic.
  std::array<bool, 3> axes{true, true, true};
  /// The period vectors, one per axis, those of periodic axes are read; they need not be parallel to the
  /// axes. Default: the extents of the bounding box.
  std::optional<std::array<std::array<double, 3>, 3>> periods;
  /// Pairs of vertices that are one vertex ($Periodic of a file), instead of all that lie a period apart. The
  /// vertices of a pair may lie any lattice vector apart.
  std::vector<std::array<Index, 2>> pairs;
  /// How far copies may be from where they should be; relative to the bounding-box diagonal.
  double tolerance = 1e-6;
  /// Where the quotient is no simplicial complex, split edges of the tile until it is, instead of refusing.
  bool refine = false;
};

/// The options for a tile of which a file says what is glued: pairs of vertices that are one, and the
/// translations between them (io::periodic_pairs). The periods are a basis of the lattice of the
/// translations, each one named by the axis it is most parallel to; axes without a period are not periodic.
/// \throw InputError if there is no translation, or they generate no lattice
PeriodicOptions options_of_pairs(std::vector<std::array<Index, 2>> pairs,
                                 std::span<const std::array<double, 3>> translations);

/// A side of a tile and its copy: faces of the boundary that are glued, a lattice vector apart. Face f of one
/// is face f of the other, corner by corner.
struct PeriodicSide {
  LatticeVector shift{};    ///< from master to slave
  FacetList master, slave;  ///< of vertices of tile_lists()
};

/// What the elements of tile_lists() were in the input.
struct PeriodicSources {
  std::vector<Index> facets;    ///< per facet: that which it is a part of
  std::vector<Index> vertices;  ///< per vertex; no_index for those of splits and of `refine`
};

/// What was found, and what had to be done.
struct PeriodicReport {
  std::array<std::size_t, 4> simplices{};  ///< of the root, by dimension
  long euler = 0;                          ///< V - E + F - T of the root
  std::vector<std::size_t> with_copies;    ///< [n]: vertices of the root with n copies in the tile
  double largest_shift = 0;      ///< of a copy from where it should be, to which it was moved if that is more
                                 ///< than rounding (1e-15); relative to the bounding-box diagonal
  std::size_t split_edges = 0;   ///< edges of the root split by `refine`
  std::size_t added_facets = 0;  ///< by that
  std::size_t cut_vertices = 0;  ///< vertices of the tile added because it is not manifold there
  std::size_t cut_root_vertices = 0;  ///< the same for the root; copies of one vertex are locked
  std::size_t reversed_facets = 0;    ///< turned round to agree with the others
  std::size_t inverted_facets = 0;    ///< of negative or no volume, after that
};

/// A periodic cell as a multimesh:
///
///       root         the tile with its opposite sides glued (a torus, a cylinder, ...); no positions
///         |
///       tile         as it came in; a position per vertex, copies of a root vertex lie lattice vectors apart
///       /   \        .
///  surface  cuts     if asked for: the boundary of the material, and the sides that are glued
///
/// Whatever is done on any of the meshes is done to all copies. What attributes interpolate on the tile stays
/// periodic: each copy of an edge is the same edge, shifted. Vertices on the sides, which have 2, 4 or 8
/// copies, are vertices like others to move and to collapse onto; only their number of copies stays, and so
/// swaps that would move the sides themselves are refused. The sides need not stay flat.
///
/// Source: Codimensional MultiMeshing, section 5 (periodic domains); matching, refinement and the rules for
/// copies are our own.
class PeriodicDomain {
 public:
  using Point = Eigen::Vector3d;

  /// \throw InputError naming the element: indices out of range, coordinates that are not finite, a vertex on
  ///        a side without partner or with two, a pair that is no lattice vector apart, sides that do not
  ///        match facet by facet; and, but with `refine`, if the quotient is no proper simplicial complex,
  ///        naming the period that is too short and an edge (at least three edges must lead round each
  ///        period). Cost: sorting
  explicit PeriodicDomain(const PeriodicTile& tile, const PeriodicOptions& options = {});
  ~PeriodicDomain();
  PeriodicDomain(PeriodicDomain&&) noexcept;

  MultiMesh& tree();
  const MultiMesh& tree() const;
  NodeId tile() const;
  const PeriodicReport& report() const;
  const Lattice& lattice() const;
  double diagonal() const;  ///< of the bounding box of the tile as it came in

  /// Of the vertices of the tile. If the input was manifold and was not refined, vertex and facet i of the
  /// tile are vertex and facet i of the input; refinement adds vertices after those.
  VertexAttribute<Point>& positions();
  const VertexAttribute<Point>& positions() const;
  /// Of the vertices of the tile: how many periods each lies from the place that all copies of its root
  /// vertex have in common.
  VertexAttribute<LatticeVector>& offsets();
  const VertexAttribute<LatticeVector>& offsets() const;
  /// Has both, and where vertices come from, follow the operations.
  void attach(Propagation& propagation);

  /// Of the tile as it was built: the facet and the vertex of the input; no_index for vertices of `refine`.
  const std::vector<Index>& input_facets() const;
  const std::vector<Index>& input_vertices() const;

  /// The place of a vertex of the tile without its offset: equal for all copies of a root vertex.
  Point common_place(Index tile_vertex) const;
  /// The place of a vertex of any mesh of the tree, by some copy of it in the tile.
  Point place(NodeId n, Dart vertex) const;
  /// The largest distance between common_place of copies of one vertex; relative to the bounding-box
  /// diagonal. Rounding makes it differ from 0. Cost: linear
  double mismatch() const;

  /// Moves a vertex of any mesh, with all its copies in the tile. Refused for locked vertices, and by what is
  /// asked of relocations. \pre attached to `propagation`
  Outcome move(Propagation& propagation, NodeId n, Dart vertex, const Point& by);

  /// The boundary of the material within the tile, without the sides that are glued, as a child of the tile.
  /// \return nothing if there is none. \throw as add_child_from_tags
  std::optional<NodeId> add_surface();
  /// The sides that are glued, as a child of the tile. \return nothing if there are none
  std::optional<NodeId> add_cuts();
  /// The faces between different regions, as a child of the root, for they may lie in the sides: regions then
  /// keep their shape. \return nothing if there are none
  std::optional<NodeId> add_interfaces();

  /// The region of a facet of the tile. Facets that a swap makes anew have that of one of the old ones: add
  /// the interfaces if there are several.
  PeriodicTile::Region region(Index tile_facet) const;

  // --- to be written, and glued again as PeriodicDomain(tile_lists(), gluing())
  /// The tile as it is now, without dead elements.
  PeriodicTile tile_lists() const;
  /// Its periods, and its pairs: each copy of a vertex with the one of the lowest number.
  PeriodicOptions gluing() const;
  /// Its sides, one entry per lattice vector. For $Periodic: io::add_periodic_faces.
  std::vector<PeriodicSide> sides() const;
  PeriodicSources sources() const;

 private:
  struct Data;
  std::unique_ptr<Data> data_;
};

/// Refuses operations after which a facet of the tile around any copy of the vertex or edge has negative or
/// no volume, by exact signs. Triangles: no area as seen against the mean normal of the tile, so that tiles
/// that are not flat must be graphs over their mean plane. Cost: the stars of all copies.
class TileStaysPositive final : public Invariant {
 public:
  explicit TileStaysPositive(const PeriodicDomain& domain);
  bool after(const Event& event) override;

 private:
  const PeriodicDomain& domain_;
  Eigen::Vector3d normal_;
  DartBuffer star_;
};

/// The volume of a tetrahedron of the tile; the area of a triangle as seen along `normal`. Signed.
double signed_measure(const PeriodicDomain& domain, Index facet, const Eigen::Vector3d& normal);
/// Its sign, exactly: of orient3d, or orient_against(normal, ..).
int orientation(const PeriodicDomain& domain, Index facet, const Eigen::Vector3d& normal);
/// Unit, of a tile of triangles; 0 for tetrahedra.
Eigen::Vector3d mean_normal(const PeriodicDomain& domain);

}  // namespace multimesh
