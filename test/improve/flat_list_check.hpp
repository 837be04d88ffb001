// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "multimesh/domains/tet_domain.hpp"

namespace multimesh::test {

/// Facts about a list of tetrahedra, computed only from their corners' coordinates: points with equal
/// coordinates are the same. Shares no code with the library.
struct FlatListFacts {
  long components = 0, face_components = 0, euler = 0, boundary_euler = 0, pinched_edges = 0;
  long crowded_faces = 0, hanging = 0;
  double boundary_area = 0;
  std::map<int, double> volumes;
};

FlatListFacts facts_of(const TaggedTetrahedra& list);

/// A sentence for each fact that differs; empty if none does. `relative`: by how much areas and volumes may.
std::string compare(const FlatListFacts& before, const FlatListFacts& after, double relative = 1e-11);

}  // namespace multimesh::test
