// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>
#include <string>

#include "multimesh/domains/textured_surface.hpp"
#include "multimesh/embedding.hpp"

namespace multimesh {

struct RemeshOptions {
  /// The requested edge length, in the units of the positions. Must be given.
  double length = 0;
  /// Rounds of split, collapse, swap and smoothing.
  int iterations = 10;
  bool lock_boundary = false;  ///< boundary edges and their vertices stay as they are
  /// The same for edges along which a chart is cut open or ends, positions and texture coordinates.
  bool lock_seams = false;
  /// If more faces are expected, by expected_faces(), the mesh is refused before any change.
  std::size_t max_faces = 50'000'000;
  /// Called after each round with its number, from 1 on. May throw: the tree is valid then.
  std::function<void(int round)> progress;
  /// Called between rounds. Other code may then operate on the tree if its operations carry these attributes
  /// and leave the surface the same set of points.
  std::function<void(int round, std::span<Attribute* const> carried)> between_rounds;
};

struct RemeshResult {
  std::size_t splits = 0, collapses = 0, swaps = 0, moves = 0;
  std::size_t edges = 0;             ///< of the surface, at the end
  std::size_t edges_in_range = 0;    ///< of these, those within 4/5 to 4/3 of the requested length
  double shortest = 0, longest = 0;  ///< of these
  double seconds = 0;                ///< by the wall clock
};

/// The approximate number of faces of a surface with edges of this length: those that its area requires, and
/// one per edge of its boundary. Infinite if it is too large for a double. Cost: linear.
double expected_faces(const Mesh& surface, const Coordinates& positions, double length);
double expected_faces(const TexturedSurface& surface, double length);

/// Whether the length was reached: at least 90 % of the edges are in range, none is longer than twice the
/// length or shorter than a quarter of it. Curves and vertices that stay may prevent it.
bool length_reached(const RemeshResult& result, double length);

/// Isotropic remeshing of a surface, anywhere in a tree: gives all edges about the same length, triangles
/// good angles, vertices about six neighbours. The rest of the tree follows: each seam of a mesh below, each
/// curve and each boundary stays a curve of the same topology. It is split, collapsed along itself and
/// smoothed along itself. Vertices where such curves end, meet or change stay where they are, as do locked
/// ones; special edges between two locked vertices are not split.
///
/// At the end, positions are on the input's surface and curves, and charts below have the coordinates of the
/// input at that point. If the embedding tells parts of the plane surface, or of the tetrahedra around it,
/// and there are no charts, these parts then get their areas or volumes back (to 1e-9 of each, if possible):
/// vertices on curves, or on the surface, leave the input where it bends, in steps of at most a twentieth of
/// the length. No triangle reverses its normal; none of a chart flips or loses its area. The
/// embedding adds further conditions.
///
/// \throw UsageError if the mesh is not a surface or has no coordinates in space; InputError for options out
/// of range, or if more faces are expected than options.max_faces. Cost: O(n log n) per round.
/// Source: Botsch, Kobbelt, A remeshing approach to multiresolution modeling, 2004.
RemeshResult remesh(const Embedding& embedding, NodeId surface, const RemeshOptions& options);

/// The same for a textured surface with all its sets of texture coordinates, colours, curves, labels and hard
/// edges.
RemeshResult remesh(TexturedSurface& surface, const RemeshOptions& options);

}  // namespace multimesh
