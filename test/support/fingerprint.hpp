// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "test/support/trees.hpp"

namespace multimesh::test {

/// Every word of a tree: connectivity, counts, status bits, anchors, links and positions of all meshes,
/// dead elements included (but for what is in dead slots of a tetrahedral mesh). Equal fingerprints: nothing
/// has changed.
std::vector<std::uint64_t> fingerprint(Tree& tree);

}  // namespace multimesh::test
