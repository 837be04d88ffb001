// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "multimesh/build.hpp"
#include "multimesh/domains/periodic_domain/lattice.hpp"
#include "multimesh/operations.hpp"

namespace multimesh {

class Embedding;

/// A cell of a periodic pattern as plain lists: triangles or tetrahedra in a box that they need not fill
/// (holes, microstructures). Vertices on opposite sides are different ones, at the same places up to a
/// period.
struct PeriodicTile {
  using Region = std::int32_t;
  std::vector<std::array<double, 3>> points;
  FacetList facets;               ///< dimension 2 or 3, into points
  std::vector<Region> regions{};  ///< per facet, or empty: all 0

  /// Faces, edges and points of the facets that are to be kept, with their tags.
  struct Listed {
    FacetList simplices;
    std::vector<Region> tags;  ///< one each
  };
  std::array<Listed, 3> listed{{{{0, 0, {}}, {}}, {{1, 0, {}}, {}}, {{2, 0, {}}, {}}}};  ///< by dimension
};

/// What a tile lists of one simplex of the root: the tags of its copies. A copy is named by the lattice
/// vector that leads to it from the copy with the least one.
struct PeriodicLabel {
  struct Copy {
    LatticeVector at;
    PeriodicTile::Region tag;
    friend auto operator<=>(const Copy&, const Copy&) = default;
  };
  std::vector<Copy> copies;
  friend auto operator<=>(const PeriodicLabel&, const PeriodicLabel&) = default;
};

struct PeriodicOptions {
  /// The axes among x, y, z along which the tile is periodic. Those along which it has no extent are dropped,
  /// unless periods are given.
  std::array<bool, 3> axes{true, true, true};
  /// The period vectors, one per axis; only those of periodic axes are read. They need not be parallel to the
  /// axes. Default: the extents of the bounding box.
  std::optional<std::array<std::array<double, 3>, 3>> periods;
  /// Pairs of vertices that are one vertex ($Periodic of a file), instead of all pairs a period apart. The
  /// vertices of a pair may lie any lattice vector apart.
  std::vector<std::array<Index, 2>> pairs;
  /// How far copies may be from their expected place; relative to the bounding-box diagonal.
  double tolerance = 1e-6;
  /// If the quotient is not a simplicial complex, split edges of the tile until it is, instead of refusing.
  bool refine = false;
  /// Keep the faces between facets of different regions. Regions then keep their shape.
  bool interfaces = false;
  /// In tiles of triangles, vertices where an interface or the boundary bends by at least this, in radians,
  /// keep their places. Only with `interfaces`.
  double corner_angle = std::numeric_limits<double>::infinity();
  /// In tiles of tetrahedra, edges at which the surface of the material, an interface or listed faces bend by
  /// at least this, in radians, are kept as curves.
  double feature_angle = std::numeric_limits<double>::infinity();
};

/// The options for a tile whose file says what is glued: pairs of vertices that are one, and the translations
/// between them (io::periodic_pairs). The periods are a basis of the lattice of the translations, each named
/// by the axis it is most parallel to; axes without a period are not periodic. \throw InputError if there is
/// no translation, or they generate no lattice
PeriodicOptions options_of_pairs(std::vector<std::array<Index, 2>> pairs,
                                 std::span<const std::array<double, 3>> translations);

/// A side of a tile and its copy: glued faces of the boundary, a lattice vector apart. Face f of one is face
/// f of the other, corner by corner.
struct PeriodicSide {
  LatticeVector shift{};    ///< from master to slave
  FacetList master, slave;  ///< of vertices of tile_lists()
};

/// A vertex of tile_lists() and the one of its copies with the lowest number.
struct PeriodicCopy {
  Index slave, master;
  LatticeVector shift;  ///< from master to slave
};

/// The elements of the input from which those of tile_lists() come.
struct PeriodicSources {
  std::vector<Index> facets;    ///< per facet: the input facet that it is part of
  std::vector<Index> vertices;  ///< per vertex; no_index for those of splits and of `refine`
};

/// What was found, and what had to be changed.
struct PeriodicReport {
  std::array<std::size_t, 4> simplices{};  ///< of the root, by dimension
  long euler = 0;                          ///< V - E + F - T of the root
  std::vector<std::size_t> with_copies;    ///< [n]: vertices of the root with n copies in the tile
  double largest_shift = 0;      ///< of a copy from its expected place, to which it was moved if that is more
                                 ///< than rounding (1e-15); relative to the bounding-box diagonal
  std::size_t split_edges = 0;   ///< edges of the root split by `refine`
  std::size_t added_facets = 0;  ///< by `refine`
  std::size_t cut_vertices = 0;  ///< vertices added to the tile because it is not manifold there
  std::size_t cut_root_vertices = 0;   ///< the same for the root; copies of one vertex are locked
  std::size_t reversed_facets = 0;     ///< reversed to agree with the others
  std::size_t inverted_facets = 0;     ///< with negative or no volume, after that
  std::array<bool, 3> dropped_axes{};  ///< without extent
  std::size_t missing_listed = 0;      ///< listed simplices that are not in the tile
};

/// What algorithms may do to the sides of a tile.
enum class TileSides : std::uint8_t {
  flat,    ///< each side that lies in one plane stays there; its vertices move within it
  free,    ///< they move like the inside, all copies alike
  frozen,  ///< nothing
};

/// A periodic cell as a multimesh:
///
///           root           the tile with its opposite sides glued (a torus, a cylinder, ...); no positions
///          /    \         .
///       tile   listed      faces, edges and points that the tile lists, and interfaces between regions:
///       children /   \             of the root, because they may lie in the sides
///  surface  cuts           if asked for: the boundary of the material, and the sides that are glued
///
/// The tile is as it came in; copies of a root vertex lie lattice vectors apart.
///
/// An operation on any of the meshes is applied to all copies. Values that attributes interpolate on the tile
/// stay periodic, because each copy of an edge is the same edge, shifted. Vertices on the sides, which have
/// 2, 4 or 8 copies, can be moved and collapsed onto like others. Only their number of copies is fixed; swaps
/// that would move the sides themselves are therefore refused. The sides need not stay flat.
///
/// Source: Codimensional MultiMeshing, section 5 (periodic domains); matching, refinement and the rules for
/// copies are our own.
class PeriodicDomain {
 public:
  /// \throw InputError naming the element: indices out of range, coordinates that are not finite, a vertex
  /// on a side without a partner or with two, a pair that is not a lattice vector apart, sides that do not
  /// match facet by facet. Without `refine`, also if the quotient is not a proper simplicial complex, naming
  /// the period that is too short and an edge (at least three edges must lead round each period). Cost:
  /// sorting
  explicit PeriodicDomain(const PeriodicTile& tile, const PeriodicOptions& options = {});
  ~PeriodicDomain();
  PeriodicDomain(PeriodicDomain&&) noexcept;
  PeriodicDomain& operator=(PeriodicDomain&&) noexcept;

  MultiMesh& tree();
  const MultiMesh& tree() const;
  NodeId tile() const;
  const PeriodicReport& report() const;
  const Lattice& lattice() const;
  double diagonal() const;  ///< of the bounding box of the input tile

  /// Per vertex of the tile. If the input was manifold and was not refined, vertex and facet i of the tile
  /// are vertex and facet i of the input; refinement appends vertices after those.
  VertexAttribute<Vec3>& positions();
  const VertexAttribute<Vec3>& positions() const;
  /// Per vertex of the tile: the number of periods from the common place of all copies of its root vertex to
  /// this copy.
  VertexAttribute<LatticeVector>& offsets();
  const VertexAttribute<LatticeVector>& offsets() const;
  /// Makes both, and the sources of vertices, follow the operations.
  void attach(Propagation& propagation);
  /// The tile with its positions, for algorithms on it and on meshes below it. A vertex moves with all its
  /// copies, and no facet may be inverted (triangles, as seen against the mean normal: unless some are at
  /// first). In a tile of triangles, side edges are curves: vertices of sides stay on them, and their ends do
  /// not move. A tile of tetrahedra whose sides may move is anchored: one vertex with the most copies is
  /// locked, with all of them. The root has no positions, nor have its other children. Must not outlive the
  /// domain. Cost: linear
  Embedding embedding(TileSides sides = TileSides::flat);

  /// For the tile as built: the facet and the vertex of the input; no_index for vertices of `refine`.
  const std::vector<Index>& input_facets() const;
  const std::vector<Index>& input_vertices() const;

  /// The place of a vertex of the tile without its offset: equal for all copies of a root vertex.
  Vec3 common_place(Index tile_vertex) const;
  /// The place of a vertex of any mesh of the tree, at some copy of it in the tile.
  Vec3 place(NodeId n, Dart vertex) const;
  /// The largest distance between common_place of copies of one vertex; relative to the bounding-box
  /// diagonal. Only rounding makes it differ from 0. Cost: linear
  double mismatch() const;

  /// Moves a vertex of any mesh, with all its copies in the tile. Refused for locked vertices, and by the
  /// invariants on relocations. \pre attached to `propagation`
  Outcome move(Propagation& propagation, NodeId n, Dart vertex, const Vec3& by);

  /// Adds the boundary of the material within the tile, without the glued sides, as a child of the tile.
  /// \return nothing if there is none. \throw as add_child_from_tags
  std::optional<NodeId> add_surface();
  /// Adds all that algorithms on a tile of tetrahedra take for its surface as a child of the tile: that of
  /// the material, interfaces and listed faces. What is glued is in it once, at one of its two places. The
  /// same one when called again. \return nothing if there is none. \throw as add_child_from_tags
  std::optional<NodeId> add_walls();
  /// Adds the glued sides as a child of the tile; algorithms then take them for a surface that is kept.
  /// \return nothing if there are none
  std::optional<NodeId> add_cuts();
  /// The mesh of the listed simplices of dimension k, a child of the root; nothing if there are none. That of
  /// the faces has the interfaces as well, that of the edges in dimension 3 also where listed faces and
  /// interfaces meet, end, or change their tags.
  std::optional<NodeId> listed(int k) const;
  /// What the tile lists of a facet of that mesh.
  const PeriodicLabel& label(int k, Index facet) const;

  /// The region of a facet of the tile. New facets of a swap have the region of one of the old ones: with
  /// several regions, keep the interfaces.
  PeriodicTile::Region region(Index tile_facet) const;

  // --- for writing, and gluing again as PeriodicDomain(tile_lists(), gluing())
  /// The current tile, without dead elements. Of what it lists, each copy that had a tag has it.
  PeriodicTile tile_lists() const;
  /// All copies of its vertices but those of the lowest numbers, by root vertex.
  std::vector<PeriodicCopy> copies() const;
  /// Its periods, and as pairs its copies.
  PeriodicOptions gluing() const;
  /// Its sides, one entry per lattice vector. For $Periodic: io::add_periodic_faces.
  std::vector<PeriodicSide> sides() const;
  PeriodicSources sources() const;
  /// Whether all its sides are flat: faces that are glued by the same lattice vector lie in one plane, or on
  /// one line, as those of a box or a hexagon do.
  bool has_flat_sides() const;

  struct Data;  ///< private to the implementation

 private:
  Attribute& sources_of_vertices();

  std::unique_ptr<Data> data_;
};

/// The signed volume of a tetrahedron of the tile; the signed area of a triangle as seen along `normal`.
double signed_measure(const PeriodicDomain& domain, Index facet, const Vec3& normal);
/// Its sign, exactly. KeepsOrientation(positions(), mean_normal(domain)) keeps all of them positive around
/// all copies; a tile of triangles that is not flat must then be a graph over its mean plane.
int orientation(const PeriodicDomain& domain, Index facet, const Vec3& normal);
/// The unit mean normal of a tile of triangles; 0 for tetrahedra.
Vec3 mean_normal(const PeriodicDomain& domain);

}  // namespace multimesh
