// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>

#include "multimesh/mesh.hpp"

namespace multimesh::test {

/// What local operations may not change in a mesh. Counted from the facets' vertices alone.
struct Topology {
  long euler = 0;
  long components = 0;
  long boundary = 0;  ///< loops (dimension 2) or end points (dimension 1)
  friend bool operator==(const Topology&, const Topology&) = default;
};

Topology topology(const Mesh& mesh);

}  // namespace multimesh::test
