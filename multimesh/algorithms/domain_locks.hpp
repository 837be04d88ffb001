// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/domains/tet_domain.hpp"
#include "multimesh/embedding.hpp"

namespace multimesh {

/// The parts of a TetDomain that an algorithm leaves unchanged.
struct DomainLocks {
  std::vector<TetDomain::Tag> locked_patches = {};  ///< triangles with these tags stay unchanged
  std::vector<TetDomain::Tag> locked_regions = {};  ///< so do tetrahedra
};

/// No operation may change any of these. `embedding`: of the domain, which must outlive it.
void lock(Embedding& embedding, const TetDomain& domain, const DomainLocks& locks);

}  // namespace multimesh
