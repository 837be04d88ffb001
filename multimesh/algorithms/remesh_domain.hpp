// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/domain_locks.hpp"
#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/remesh.hpp"
#include "multimesh/domains/periodic_domain.hpp"

namespace multimesh {

/// For a surface that tetrahedra follow.
struct SurfaceRemeshOptions : RemeshOptions {
  /// The tetrahedra are improved towards this AMIPS energy as the surface changes, and at the end.
  double target_amips = 10;
  /// Passes of improvement after each round, and at the end.
  int passes_between = 2, passes_at_end = 40;
  /// At the end, no edge is split for quality once there are this many times the tetrahedra left by then.
  double max_growth = 10;
};

/// For that of a TetDomain.
struct DomainRemeshOptions : SurfaceRemeshOptions, DomainLocks {};

struct DomainRemeshResult {
  RemeshResult surface;
  ImproveResult tetrahedra;  ///< the last improvement
};

/// Isotropic remeshing of the surface of a domain (boundary, interfaces and listed triangles) while the
/// tetrahedra follow; all of them keep a positive volume, exactly. Patches, regions and curves are kept as in
/// remesh(). After each round the tetrahedra are improved with the current surface fixed, which makes room
/// for the next round. \throw InputError as remesh() and improve(), and if the domain has no surface. Cost:
/// that of both, per round.
DomainRemeshResult remesh(TetDomain& domain, const DomainRemeshOptions& options);

/// The same in a periodic tile of tetrahedra, across its sides: of the surface of PeriodicDomain::add_walls.
/// All copies stay lattice vectors apart, and the lines in which the sides cut the surface are curves.
DomainRemeshResult remesh_walls(PeriodicDomain& domain, TileSides sides, const SurfaceRemeshOptions& options);

}  // namespace multimesh
