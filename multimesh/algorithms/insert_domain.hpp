// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "multimesh/algorithms/insert.hpp"
#include "multimesh/domains/tet_domain.hpp"

namespace multimesh {

/// An arrangement as a file has it.
struct ArrangementLists {
  /// Points at their nearest doubles. Regions: 1 outside, then what faces of the soup enclose or part, in the
  /// order of the tetrahedra. Patches: labels of the soup; where triangles of different labels overlap, a tag
  /// of its own.
  TaggedTetrahedra tets;
  struct Overlap {
    TaggedTetrahedra::Tag tag;
    std::vector<TaggedTetrahedra::Tag> labels;  ///< ascending
  };
  std::vector<Overlap> overlaps;
  TaggedTetrahedra::Tag regions = 0;
  std::size_t inverted = 0;  ///< tetrahedra without positive volume, because a corner was rounded
};

/// Cost: sorting
ArrangementLists lists_of(const Arrangement& arrangement, const TriangleSoup& soup);

}  // namespace multimesh
