// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <ostream>
#include <string>

#include "multimesh/algorithms/insert.hpp"

namespace multimesh::test {

/// A name, and how to make one of its soups.
struct SoupKind {
  std::string name;
  std::function<TriangleSoup(unsigned seed)> make;
  friend void PrintTo(const SoupKind& k, std::ostream* out) { *out << k.name; }
};

/// Random triangles; on a coarse grid of integers, where everything degenerates; duplicates; slivers; without
/// area; sharing vertices; T-junctions; boxes that touch and nest; overlapping in one plane.
const std::vector<SoupKind>& soup_kinds();

/// With its low corner there, facing outwards.
TriangleSoup cube(const Vec3& low, double edge);

}  // namespace multimesh::test
