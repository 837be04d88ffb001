// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <compare>
#include <ostream>

#include "multimesh/mesh.hpp"

namespace multimesh::test {

/// What local operations may not change in a mesh. Counted from the facets' vertices alone.
struct Topology {
  long euler = 0;
  long components = 0;
  long boundary = 0;        ///< surfaces (dimension 3), loops (2) or end points (1)
  long boundary_euler = 0;  ///< of the boundary of a mesh of dimension 3
  friend bool operator==(const Topology&, const Topology&) = default;
  friend void PrintTo(const Topology& t, std::ostream* out) {
    *out << "euler " << t.euler << ", components " << t.components << ", boundary " << t.boundary
         << ", its euler " << t.boundary_euler;
  }
};

Topology topology(const Mesh& mesh);

}  // namespace multimesh::test
