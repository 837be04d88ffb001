// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "multimesh/algorithms/domain_locks.hpp"
#include "multimesh/algorithms/improve.hpp"
#include "multimesh/algorithms/remesh.hpp"

namespace multimesh {

/// Of the surface of a TetDomain.
struct DomainRemeshOptions : RemeshOptions, DomainLocks {
  /// The tetrahedra are improved towards this AMIPS energy as the surface changes, and at the end.
  double target_amips = 10;
  /// Passes of improvement after each round, and at the end.
  int passes_between = 2, passes_at_end = 40;
};

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

}  // namespace multimesh
