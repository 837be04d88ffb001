// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/mesh.hpp"

namespace multimesh::test {

/// Betti numbers b0..bd of a mesh modulo 2, from the vertices of its facets alone.
std::vector<long> betti(const Mesh& mesh);

}  // namespace multimesh::test
