// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "multimesh/algorithms/textured_surface.hpp"

namespace multimesh {

enum class DecimateCost {
  quadric,  ///< distance to the planes of the faces merged so far (Garland & Heckbert 1997), at the best
            ///< point of the edge
  length,   ///< shortest edge first, to its midpoint (the paper's section 5.1)
};

/// Give at least one target; whichever is met first ends the run.
struct DecimateOptions {
  DecimateCost cost = DecimateCost::quadric;
  /// Stop at this many triangles or fewer. 0: no such target.
  std::size_t faces = 0;
  /// Stop before a collapse whose cost exceeds this length, relative to the diagonal of the bounding box.
  /// Quadric: root mean square distance to the planes merged so far, those through boundaries and seams
  /// counted `curve_weight` times; length: edge length. An estimate, no bound on the surfaces' distance.
  double max_error = std::numeric_limits<double>::infinity();
  /// Weight of planes through boundary edges and seams, orthogonal to the surface, relative to the surface's.
  double curve_weight = 10;
  /// No face may turn its normal by more than this, per collapse, in radians.
  double max_normal_turn = 1.3;
  /// Called about every thousand collapses with the number of triangles left; may throw to abandon the run.
  std::function<void(std::size_t faces)> progress = {};
};

/// How often something stood in the way, by name: a Check, or the name of an invariant.
struct RefusalCount {
  std::string reason;
  std::size_t count;
};

struct DecimateResult {
  enum class Stop { faces, max_error, exhausted };
  Stop stop = Stop::exhausted;
  std::size_t faces_before = 0, faces_after = 0;
  std::size_t tried = 0, collapsed = 0;
  std::vector<RefusalCount> refused;  ///< over the whole run, most frequent first
  /// If the run was exhausted: the edges that are left, by what keeps each from being collapsed.
  std::vector<RefusalCount> blocking;
  double seconds = 0;   ///< of the collapse loop, by the wall clock
  double max_cost = 0;  ///< of the collapses done, a length relative to the bounding-box diagonal
};

/// Collapses edges of a textured surface, cheapest first. Position and texture coordinates of a merged
/// vertex denote the same point of the collapsed edge, in every chart. Kept: the topology of the surface and
/// of each chart, the graph of the seams, and every triangle's orientation in the texture and (nearly) in
/// space. Deterministic. Cost: O(n log n). \throw InputError if no target is given
DecimateResult decimate(TexturedSurface& surface, const DecimateOptions& options);

}  // namespace multimesh
