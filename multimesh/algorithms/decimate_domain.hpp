// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/domain_locks.hpp"
#include "multimesh/algorithms/improve.hpp"

namespace multimesh {

/// For the surface of a TetDomain.
struct DomainDecimateOptions : DecimateOptions, DomainLocks {
  /// Between rounds, and at the end, tetrahedra are improved towards this AMIPS energy.
  double target_amips = 10;
  /// Passes of improvement after each round; 0: none, and the surface gets stuck sooner.
  int passes_between = 2;
  /// The same at the end; 0: the tetrahedra stay as decimation has left them.
  int passes_at_end = 0;
};

struct DomainDecimateResult {
  DecimateResult surface;
  std::optional<ImproveResult> tetrahedra;  ///< the last improvement, if any was asked for at the end
};

/// Decimates the surface of a domain (boundary, interfaces and listed triangles) while the tetrahedra follow;
/// all of them keep a positive volume, exactly. Patches, regions and curves are kept as decimate() keeps
/// charts and curves. Each time that a fifth of the faces is gone, or nothing more can be collapsed, inner
/// edges shorter than those of the surface are collapsed and the tetrahedra improved with the current surface
/// fixed, which makes room for the next round. \throw InputError as decimate() and improve(), and if the
/// domain has no surface. Cost: that of both, per round
DomainDecimateResult decimate(TetDomain& domain, const DomainDecimateOptions& options);

}  // namespace multimesh
