// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "multimesh/mesh.hpp"

namespace multimesh::test {

/// A name and a mesh, for tests that every mesh must pass.
struct MeshCase {
  std::string name;
  std::function<std::unique_ptr<Mesh>()> make;
  friend void PrintTo(const MeshCase& c, std::ostream* out) { *out << c.name; }
};

/// Points, edge, triangle and tetrahedral meshes: with and without boundary, one facet, several components,
/// and after random operations, with dead elements.
const std::vector<MeshCase>& mesh_cases();

/// Splits, collapses and flips on random edges of one mesh.
void shake(Mesh& mesh, unsigned seed, int operations);

}  // namespace multimesh::test
