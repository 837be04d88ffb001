// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "multimesh/algorithms/decimate.hpp"
#include "multimesh/algorithms/domain_locks.hpp"
#include "multimesh/algorithms/improve.hpp"
#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh {

/// For a surface that tetrahedra follow.
struct SurfaceDecimateOptions : DecimateOptions {
  /// Between rounds, and at the end, tetrahedra are improved towards this AMIPS energy.
  double target_amips = 10;
  /// Passes of improvement after each round; 0: none, and the surface gets stuck sooner.
  int passes_between = 2;
  /// The same at the end; 0: the tetrahedra stay as decimation has left them.
  int passes_at_end = 0;
  /// Then no edge is split for quality once there are this many times the tetrahedra that decimation has
  /// left.
  double max_growth = 10;
};

/// For that of a TetDomain.
struct DomainDecimateOptions : SurfaceDecimateOptions, DomainLocks {};

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

/// The same across the sides of a periodic tile. In one of tetrahedra, the surface is that of
/// PeriodicDomain::add_walls; one of triangles is decimated itself. All copies stay lattice vectors apart,
/// and the lines in which the sides cut the surface are curves.
DomainDecimateResult decimate(PeriodicDomain& domain, TileSides sides, const SurfaceDecimateOptions& options);

}  // namespace multimesh
