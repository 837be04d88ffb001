// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "multimesh/domains/textured_surface.hpp"
#include "multimesh/embedding.hpp"

namespace multimesh {

enum class DecimateCost {
  quadric,  ///< deviation of position and texture coordinates together, at the best point
  length,   ///< shortest edge first, to its midpoint (Codimensional MultiMeshing, section 5.1)
};

/// Give at least one target: faces, max_error or max_texture_error. All limits hold at once.
struct DecimateOptions {
  // --- when to stop
  /// Stop at this many triangles or fewer. 0: no such target.
  std::size_t faces = 0;
  /// Intermediate levels of detail: numbers of triangles, descending, each above `faces`. on_level is called
  /// with the position in the list when that many or fewer are left; then the run continues.
  std::vector<std::size_t> levels = {};
  std::function<void(std::size_t level)> on_level = {};

  // --- bounds; lengths are relative to the diagonal of the bounding box
  /// No point of the surface passed to this call, insides of triangles included, is farther than this from
  /// the resulting surface, and no vertex of the result is farther than this from the passed surface.
  /// Guaranteed; in doubt, a collapse is refused.
  double max_error = std::numeric_limits<double>::infinity();
  /// Each vertex of the texture is drawn at most this far from its place. Guaranteed for vertices; points
  /// inside triangles are not examined.
  double max_texture_error = std::numeric_limits<double>::infinity();
  /// No normal deviates by more than this from those of the input's triangles merged into it; radians.
  double max_normal_deviation = std::numeric_limits<double>::infinity();
  /// No triangle gets an aspect ratio (longest edge over shortest height) above this, unless one was already
  /// as bad there. At least 2 / sqrt(3), that of the equilateral triangle.
  double max_aspect_ratio = std::numeric_limits<double>::infinity();
  /// No face may turn its normal by more than this per collapse, in radians, below pi.
  double max_normal_turn = 1.3;

  // --- what stays where it is
  bool lock_boundary = false;  ///< boundary vertices keep their place and their edges
  bool lock_seams = false;     ///< the same for vertices on seams, positions and texture coordinates

  // --- what it costs
  DecimateCost cost = DecimateCost::quadric;
  /// Weight of the texture: of the squared deviation of its content along the surface, relative to the
  /// squared distance from the surface. 0: shape only; 1: texture deviation as such.
  double uv_weight = 0.05;
  /// Weight of planes through edges of boundaries, borders and sharp curves, orthogonal to the surface.
  double curve_weight = 1;
  /// The same for edges that are only seams: where seams run on the surface matters little.
  double seam_weight = 0.1;
  /// Weight of the edges of charts in the texture, in addition to uv_weight.
  double uv_curve_weight = 3;

  /// Weight of the distance from the planes of the input beside that from the surface as it is by then.
  double memory_weight = 0.3;

  /// Called each time that a fifth of the faces is gone, or nothing more can be collapsed. Other code may
  /// then operate on the tree if its operations carry these attributes and leave the surface as it is. Then
  /// all edges are tried again, until that no longer helps.
  std::function<void(std::span<Attribute* const> carried)> between_rounds = {};
  /// Called about every thousand collapses with the number of triangles left; may throw to abandon the run.
  std::function<void(std::size_t faces)> progress = {};
};

/// How often something stood in the way, by name: a Check, or the name of a test or an invariant.
struct RefusalCount {
  std::string reason;
  std::size_t count;
};

struct DecimateResult {
  enum class Stop {
    faces,      ///< as many as wanted
    bound,      ///< edges are left, but the bounds of the options forbid every one that topology allows
    exhausted,  ///< no edge is left that may be collapsed
  };
  Stop stop = Stop::exhausted;
  std::size_t faces_before = 0, faces_after = 0;
  std::size_t tried = 0, collapsed = 0;
  std::vector<RefusalCount> refused;  ///< over the whole run, most frequent first
  /// If the target was not reached: the edges that are left, by what keeps each from being collapsed.
  std::vector<RefusalCount> blocking;
  double seconds = 0;      ///< of the collapse loop, by the wall clock
  std::size_t charts = 0;  ///< of the first texture
  /// Of the collapses done: root mean square deviation over the triangles that one changed, relative to the
  /// bounding-box diagonal. An estimate per collapse, no bound.
  double max_cost = 0;
};

/// Collapses edges of a surface, anywhere in a tree, cheapest first. Kept: the topology of all meshes, the
/// graph of the curves and of what bounds charts, every triangle's orientation in each chart and (nearly) in
/// space, and locked vertices. Everything else in the embedding follows, and its invariants add conditions:
/// for instance, that tetrahedra stay positive. Deterministic. Cost: O(n log n).
/// \throw InputError if no target is given, an option is out of range, or the surface has more than 4
/// charts; UsageError if the mesh is not a surface or has no coordinates in space
DecimateResult decimate(const Embedding& embedding, NodeId surface, const DecimateOptions& options);

/// The same for a textured surface with all its sets of texture coordinates, colours, curves, labels and hard
/// edges.
DecimateResult decimate(TexturedSurface& surface, const DecimateOptions& options);

}  // namespace multimesh
