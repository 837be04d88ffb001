// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/embedding.hpp"

namespace multimesh {

/// What of a TetDomain an algorithm leaves as it is.
struct DomainLocks {
  std::vector<TetDomain::Tag> locked_patches = {};  ///< triangles with these tags stay the same ones
  std::vector<TetDomain::Tag> locked_regions = {};  ///< so do tetrahedra
};

/// No operation may change any of these. `embedding`: of the domain, which must outlive it.
void lock(Embedding& embedding, const TetDomain& domain, const DomainLocks& locks);

}  // namespace multimesh
