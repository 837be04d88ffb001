// SPDX-License-Identifier: BSD-3-Clause
#include "multimesh/algorithms/domain_locks.hpp"

#include <algorithm>

namespace multimesh {

void lock(Embedding& embedding, const TetDomain& domain, const DomainLocks& locks) {
  if (locks.locked_patches.empty() && locks.locked_regions.empty()) return;
  embedding.keep("locked patches and regions stay", [&domain, locks](NodeId n, Index facet) {
    if (n == NodeId::root)
      return std::ranges::find(locks.locked_regions, domain.regions()[facet]) != locks.locked_regions.end();
    return n == domain.surface() &&
           std::ranges::find(locks.locked_patches, domain.patch(facet)) != locks.locked_patches.end();
  });
}

}  // namespace multimesh
