// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "multimesh/algorithms/domain_locks.hpp"

namespace multimesh {

class Attribute;
class Embedding;
class PeriodicDomain;

/// How edges of the surface and of curves may be split, at their middle, rounded to doubles.
enum class SurfaceSplits {
  none,
  exact,    ///< only where surface and curves stay the same sets of points, exactly
  rounded,  ///< also where the rounding displaces them, by at most half an ulp of each coordinate; faces and
            ///< curves that are flat up to a few ulps are then flat
};

/// What may become of a mesh inside the tetrahedra: of surfaces and curves.
enum class Confined {
  exact,     ///< it stays the same set of points: its vertices move only where it is flat, or straight
  fixed,     ///< its vertices, edges and triangles stay the same ones
  envelope,  ///< it stays within a distance of what it was, and what it was within that distance of it; where
             ///< curves are, and where more or fewer than two of its sheets meet, it is held exactly. Of
             ///< surfaces
};

struct Confinement {
  NodeId mesh;  ///< or that of the tetrahedra: what of their boundary is in no other mesh
  Confined how = Confined::exact;
  double distance = 0;  ///< of the envelope; greater than 0
};

/// How far an improvement has come.
struct ImproveProgress {
  int pass = 0;
  std::size_t above_target = 0, tets = 0;
  double seconds = 0;
};

struct ImproveOptions {
  /// Stop when no tetrahedron has an AMIPS energy above this. At least 3, that of the regular one.
  double target_amips = 10;
  /// Stop after this many passes over the tetrahedra above the target.
  int max_passes = 40;
  /// Stop after this many seconds of wall-clock time, with the best mesh so far.
  double time_limit = std::numeric_limits<double>::infinity();
  /// No edge is split for quality once the mesh has this many times its initial tetrahedra, or as many times
  /// those that the edge length requires; meshes of fewer than 500 count as 500. At least 1.
  double max_growth = 10;

  // --- sizes; lengths are those of the points
  /// Edges longer than 4/3 of this are split, regardless of quality, which is improved afterwards; edges
  /// shorter than 4/5 are collapsed where quality and surface allow it. 0: leave them as they are.
  double edge_length = 0;
  /// No edge is split that would leave halves shorter than this.
  double min_edge_length = 0;
  /// Edges longer than this are split, regardless of quality, and no operation but a split leaves one. 0: no
  /// bound.
  double max_edge_length = 0;
  bool has_sizes() const { return edge_length > 0 || max_edge_length > 0; }

  // --- what stays as it is, besides the places of surface and curves
  SurfaceSplits surface_splits = SurfaceSplits::rounded;
  /// Meshes that are not listed are held exactly.
  std::vector<Confinement> confined = {};

  /// While surfaces move in envelopes, the volume of each part of the tetrahedra changes by at most this
  /// share of it. Greater than 0; infinity: as it comes.
  double keep_volume = 1e-3;

  /// Attributes of others that follow the operations.
  std::vector<Attribute*> carried = {};

  /// Called after each pass and about once a second; may throw to abandon the run: then the domain is valid,
  /// with the improvements so far.
  std::function<void(const ImproveProgress&)> progress = {};
};

/// That the surface of a domain stays as it is: all that bounds its tetrahedra or is between them.
std::vector<Confinement> fixed_surface(const TetDomain& domain);
/// The same of a periodic tile, by PeriodicDomain::add_walls.
std::vector<Confinement> fixed_walls(PeriodicDomain& domain);

/// Of a TetDomain, by its tags.
struct DomainImproveOptions : ImproveOptions, DomainLocks {
  bool lock_surface = false;  ///< its vertices, edges and triangles stay the same ones, curves on it too
  double envelope = 0;        ///< if greater than 0: surface and interfaces may move by this, see Confined
};

/// The AMIPS energies of a mesh.
struct TetQuality {
  std::size_t tets = 0, vertices = 0, above_target = 0;
  double max_amips = 0, mean_amips = 0;
};

/// How often an operation was considered, and the results.
struct OperationCount {
  std::string name;
  std::size_t tried = 0, done = 0;
  std::vector<std::pair<std::string, std::size_t>> refused;  ///< by reason
};

/// Why an improvement ended.
enum class ImproveStop {
  done,        ///< the targets are reached, or nothing helps any more
  max_passes,  ///< or the other limits of the options
  max_growth,
  time_limit,
};

/// The edges, compared with the requested length.
struct EdgeLengths {
  double shortest = 0, longest = 0, mean = 0;
  double share_in_range = 1;  ///< of edges from 4/5 to 4/3 of the length
  std::size_t too_long = 0;   ///< edges longer than that
};

/// Why tetrahedra remain above the target: what they have in common, and the best value that this allows.
struct ImproveObstacle {
  std::string reason;
  std::size_t tets = 0;
  double max_amips = 0;             ///< of these tetrahedra
  double least_max_amips = 3;       ///< of any mesh of this domain; 3 if nothing is known
  std::array<double, 3> example{};  ///< the centre of the worst of them
};

/// How far a mesh in an envelope moved.
struct EnvelopeUse {
  NodeId mesh;
  double distance = 0;  ///< that of the envelope
  /// From the mesh to what it was, and from that to the mesh: of seven points of each triangle.
  std::array<double, 2> moved{};
};

struct ImproveResult {
  bool target_reached = false;
  ImproveStop stop = ImproveStop::done;
  int passes = 0;
  TetQuality before, after;
  EdgeLengths lengths;  ///< after; only if a length was requested
  std::vector<EnvelopeUse> envelopes;
  std::vector<OperationCount> operations;
  std::vector<ImproveObstacle> obstacles;  ///< empty if the target is reached
  /// No mesh of this domain with these surfaces and curves has a smaller max AMIPS, however it is refined: a
  /// corner of the surface, or an angle between its faces, forces it. 3 if nothing is known.
  double least_max_amips = 3;
  std::array<double, 3> least_max_amips_at{};  ///< the point that forces it
  double seconds = 0;                          ///< by the wall clock
};

/// Improves the tetrahedra of a mesh of an embedding, wherever it is in the tree, worst first, by swaps of
/// edges and faces, collapses, moves of vertices and splits, until all have an AMIPS energy of at most the
/// target. An operation is done only if the worst of the tetrahedra it replaces gets better. Topology of all
/// meshes is kept. Surface and curves stay what they are as sets of points, exactly but for rounded splits:
/// their vertices move only where they lie in exactly flat, or straight, surroundings; locked vertices never
/// do. Volumes of regions are thus kept, too. In a periodic tile, operations apply to all copies of a vertex
/// or an edge, and the sides are no surface: what they may do, its embedding says (TileSides). All tetrahedra
/// stay of positive orientation, exactly. Deterministic. Cost: some microseconds per candidate. \throw
/// InputError naming a tetrahedron that is inverted or flat, and for options out of range; nothing was
/// changed then. Source: the loop, Klingner and Shewchuk, Aggressive tetrahedral mesh improvement (2007); the
/// energy, Fu, Liu, Guo (2015), as in Hu et al., Tetrahedral meshing in the wild (2018), section 3.3
ImproveResult improve(const Embedding& embedding, NodeId node, const ImproveOptions& options = {});
ImproveResult improve(TetDomain& domain, const DomainImproveOptions& options = {});

/// Splits all edges of the tetrahedra that are longer than this at their middle, the longest ones first,
/// whatever becomes of the quality; those of surface and curves, too, unless the options lock them or forbid
/// to split them. Topology, surface, curves and volumes are kept as by improve(). Of the options, those about
/// what stays, and the time limit, count. \return how many were split. \throw InputError as improve() does
std::size_t split_long_edges(const Embedding& embedding, NodeId node, double longest,
                             const ImproveOptions& options = {});
std::size_t split_long_edges(TetDomain& domain, double longest, const DomainImproveOptions& options = {});

}  // namespace multimesh
