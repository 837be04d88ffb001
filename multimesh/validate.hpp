// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "multimesh/multi_mesh.hpp"

namespace multimesh {

/// All errors of a tree, one sentence each; empty if it is valid. Checked: the connectivity of every mesh,
/// that it is a proper simplicial complex, every anchor (alive, in its own facet), the vertex map of every
/// child (single-valued, with no degenerate image), and links (each the inverse of an anchor, none left
/// over). Cost: linear, plus a sort.
std::vector<std::string> validate(const MultiMesh& tree);

}  // namespace multimesh
